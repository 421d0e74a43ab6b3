#include "studies/kinds/search/schema.h"

#include "studies/kinds/search/measure.h"
#include "studies/parameters/shared_parameters.h"

namespace zona::studies {

namespace {

std::string measure_list() {
  std::string text;
  for (const search::Measure& measure : search::measures())
    text += " " + measure.name + ": " + measure.documentation;
  return text;
}

void declare_varied(Schema& schema, const std::string& list) {
  schema.text(list + ".key", "pulse.duration")
      .without_default()
      .doc("A key of the study with one value, e.g. \"pulse.duration\" or \"fill.fluid\".");
  schema.anything(list + ".range")
      .doc("The lowest and the highest value, as the study would have them.");
  schema.anything(list + ".values").doc("The values, instead of a range.");
  schema.choice(list + ".scale", {"linear", "logarithmic"})
      .doc("Whether a range counts evenly, or evenly in its logarithm.");
}

void declare_search_section(Schema& schema) {
  using Of = search::Measure::Of;
  schema.section("search", "What is searched, and how hard.");
  schema.file("search.study", "")
      .without_default()
      .doc(
          "The piercing study that is varied, with motion.kind = \"beam\". As it stands it is the "
          "reference: what is done today, which the designs are compared with.");
  schema
      .choices("search.tip_objectives", search::measure_names(Of::tip),
               {"mismatch", "residual_motion"})
      .doc("What is to be small about the tip's motion; chooses the designs that go on to pierce.");
  schema
      .choices("search.objectives", search::measure_names(),
               {"failed_area", "largest_strain_away", "residual_motion"})
      .doc("What is to be small in the piercings; ranks them.");
  schema.integer("search.samples", 100)
      .in("[1, 100000]")
      .doc(
          "Designs of the Latin hypercube over the ranges, for every combination of listed values; "
          "each takes a beam.");
  schema.integer("search.evaluations", 60)
      .in("[0, 100000]")
      .doc(
          "Beams that the optimiser (NLopt's Subplex) may then try for each combination of listed "
          "values and each weighting of the tip's objectives.");
  schema.integer("search.divisions", 2)
      .in("[1, 20]")
      .doc("Steps of the weightings from one objective to the next; 2 of two make three.");
  schema.integer("search.candidates", 12)
      .in("[1, 10000]")
      .doc("Designs that pierce: of each combination of listed values its Pareto front, spread.");
  schema.integer("search.refinements", 0)
      .in("[0, 10000]")
      .doc(
          "Piercings that a second optimiser (NLopt's COBYLA) may then try from the best candidate "
          "of each combination, up to as many as there are finalists, over the ranges. It makes "
          "the worst of the objectives small, each over that of the reference; what it finds "
          "becomes a candidate. 0 leaves it out.");
  schema.integer("search.finalists", 12)
      .in("[1, 10000]")
      .auto_by_default()
      .doc(
          "Candidates that pierce again with every sample of the uncertain inputs, the best by the "
          "objectives; \"auto\" takes all.");
  schema.integer("search.uncertainty_samples", 8)
      .in("[2, 10000]")
      .doc("Samples of the Latin hypercube over the uncertain inputs, the same for every design.");
  schema.number("search.confidence", 0.9)
      .in("(0, 1]")
      .doc("Share of the samples in which a design must keep to the limits.");
  schema.boolean("search.derivatives", true)
      .doc(
          "Whether reference and best design pierce again with each uncertain input at the ends of "
          "its range: differences of all measures by every input.");
  schema.texts("search.avoid", {"mercury"})
      .doc(
          "Fluids in [fill] or [[column]] that an answer must do without; designs with them are "
          "kept for comparison.");
  schema.integer("search.seed", 1).in("[0, 1000000000]").doc("Of the hypercubes.");
}

void check_limit(const Table& limit, const Complain& complain) {
  if (limit.is_auto("at_least") && limit.is_auto("at_most"))
    complain("at_least", "is missing, and so is at_most; give one or both");
}

Schema make_schema() {
  Schema schema("search",
                "Which fluid, geometry and pulse pierce with least damage: beams by the thousand, "
                "then piercings of the best, with uncertain inputs.");
  declare_search_section(schema);

  schema.list("variable", "What may be chosen: a key of the study with its values or its range.", 1,
              false);
  declare_varied(schema, "variable");

  schema.list("uncertain", "What nobody knows exactly: a key of the study with its range, sampled.",
              0, false);
  declare_varied(schema, "uncertain");
  schema.text("uncertain.source", "").doc("Where the range comes from; the report repeats it.");

  schema.list("limit", "What a design must keep to.", 0, false);
  schema.choice("limit.measure", search::measure_names())
      .without_default()
      .doc("Of the tip or of the piercing." + measure_list());
  schema.bound("limit.at_least").doc("Lowest value, with its unit.");
  schema.bound("limit.at_most").doc("Highest value, with its unit.");
  schema.check_each("limit", check_limit);

  schema.section("run", "How the program runs. The results do not depend on it.");
  declare_threads_and_log(schema);
  schema.text("run.cache", "")
      .doc(
          "Folder of the piercings' results, by what decides them, from the working directory; "
          "empty: `cases` in the run's directory. Searches and processes that share one do nothing "
          "twice.");
  schema.check([](const Configuration& study, const Complain& complain) {
    if (!study.is_auto("search.finalists") &&
        study.integer("search.finalists") > study.integer("search.candidates"))
      complain("search.finalists", "are among the candidates; needs at most as many");
  });
  return schema;
}

}  // namespace

const Schema& search_schema() {
  static const Schema schema = make_schema();
  return schema;
}

}  // namespace zona::studies
