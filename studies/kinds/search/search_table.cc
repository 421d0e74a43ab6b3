#include "studies/kinds/search/search_table.h"

namespace zona::studies::search {

namespace {

using Keys = TableKeys<SearchTable>;

void check_finalists(const Configuration& study, const Complain& complain) {
  const auto finalists = study.value(&SearchTable::finalists);
  if (finalists && *finalists > study.value(&SearchTable::candidates))
    complain(study.key(&SearchTable::finalists), "are among the candidates; needs at most as many");
}

void declare_objectives(Keys& keys) {
  keys.choices("tip_objectives", &SearchTable::tip_objectives, measure_words(Measure::Of::tip),
               {"mismatch", "residual_motion"})
      .doc("Measures of the tip's motion to minimise; they choose the designs that pierce.");
  keys.choices("objectives", &SearchTable::objectives, measure_words(),
               {"failed_area", "largest_strain_away", "residual_motion"})
      .doc("Measures of the piercings to minimise; they rank the designs.");
}

void declare_beams(Keys& keys) {
  keys.integer("samples", &SearchTable::samples, 100)
      .in("[1, 100000]")
      .doc(
          "Designs of the Latin hypercube over the ranges, for every combination of listed values; "
          "each takes a beam.");
  keys.integer("evaluations", &SearchTable::evaluations, 60)
      .in("[0, 100000]")
      .doc(
          "Beams that the optimiser (NLopt's Subplex) may then try for each combination of listed "
          "values and each weighting of the tip's objectives.");
  keys.integer("divisions", &SearchTable::divisions, 2)
      .in("[1, 20]")
      .doc(
          "Steps of the weightings from one objective to the next: 2 steps and two objectives make "
          "three weightings.");
}

void declare_piercings(Keys& keys) {
  keys.integer("candidates", &SearchTable::candidates, 12)
      .in("[1, 10000]")
      .doc(
          "Designs that pierce: for each combination of listed values, points spread over its "
          "Pareto front.");
  keys.integer("refinements", &SearchTable::refinements, 0)
      .in("[0, 10000]")
      .doc(
          "Piercings that a second optimiser (NLopt's COBYLA) may then try from the best candidate "
          "of each combination, up to as many as there are finalists, over the ranges. It "
          "minimises the worst of the objectives, each over that of the reference; the result "
          "becomes a candidate. 0 leaves it out.");
  keys.integer("finalists", &SearchTable::finalists, 12)
      .in("[1, 10000]")
      .auto_by_default()
      .doc(
          "Candidates that pierce again with every sample of the uncertain inputs, the best by the "
          "objectives; \"auto\" takes all.");
}

void declare_uncertainty(Keys& keys) {
  keys.integer("uncertainty_samples", &SearchTable::uncertainty_samples, 8)
      .in("[2, 10000]")
      .doc("Samples of the Latin hypercube over the uncertain inputs, the same for every design.");
  keys.number("confidence", &SearchTable::confidence, 0.9)
      .in("(0, 1]")
      .doc("Share of the samples in which a design must keep to the limits.");
  keys.boolean("derivatives", &SearchTable::derivatives, true)
      .doc(
          "Whether reference and best design pierce again with each uncertain input at the ends of "
          "its range, which gives the effect of every input on all measures.");
}

}  // namespace

void declare_search(Schema& schema) {
  Keys keys(schema, "search", "Base study, objectives and effort of the search.");
  keys.file("study", &SearchTable::study_file, "")
      .without_default()
      .doc(
          "The piercing study that is varied, with motion.kind = \"beam\". As it stands it is the "
          "reference: what is done today, which the designs are compared with.");
  declare_objectives(keys);
  declare_beams(keys);
  declare_piercings(keys);
  declare_uncertainty(keys);
  keys.texts("avoid", &SearchTable::avoid, {"mercury"})
      .doc(
          "Fluids in [fill] or [[column]] that an answer must do without; designs with them are "
          "kept for comparison.");
  keys.integer("seed", &SearchTable::seed, 1).in("[0, 1000000000]").doc("Seed of the hypercubes.");
  schema.check(check_finalists);
}

}  // namespace zona::studies::search
