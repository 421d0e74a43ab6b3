#include "studies/kinds/scene/run.h"

#include <nlohmann/json.hpp>

#include "studies/kinds/scene/observer.h"
#include "studies/run/run_directory.h"
#include "studies/simulation/simulation.h"

namespace zona::studies {

void run_scene(SceneCase& scene, Session& session) {
  const SimulationContext context{scene.study,
                                  output_plan(scene.study, scene.end),
                                  checkpoint_plan(scene.study, session.resume),
                                  session.directory.path(),
                                  session.threads,
                                  session.directory.log(),
                                  session.progress};
  const Eigen::Vector3d gravity = scene.model.gravity;
  Simulation simulation({std::move(scene.model), scene.step.seconds, scene.end}, context);
  SceneObserver observer(scene.study, scene.step, simulation.solver(), gravity);
  simulation.start(observer);
  session.progress.start("scene", scene.end);
  try {
    simulation.run();
    session.progress.finish();
  } catch (...) {
    session.results = simulation.results();
    throw;
  }
  session.results = simulation.results();
}

}  // namespace zona::studies
