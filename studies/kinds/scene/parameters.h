#pragma once

#include "studies/input/configuration.h"
#include "studies/input/schema.h"

namespace zona::studies {

/// The tables of a scene, one or more by each call.
void declare_scene_grid(Schema& schema);
void declare_scene_time(Schema& schema);
void declare_scene_bodies(Schema& schema);
void declare_scene_actions(Schema& schema);  ///< [[hold]], [[load]]
void declare_scene_output(Schema& schema);

/// Conditions between values of a scene.
void check_scene(Schema& schema);

}  // namespace zona::studies
