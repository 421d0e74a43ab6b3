#pragma once

#include "studies/configuration.h"
#include "studies/schema.h"

namespace zona::studies {

/// The tables of a scene, one or more by each call.
void declare_scene_grid(Schema& schema);
void declare_scene_time(Schema& schema);
void declare_scene_bodies(Schema& schema);
void declare_scene_actions(Schema& schema);   ///< [[hold]], [[load]]
void declare_scene_measures(Schema& schema);  ///< [[probe]], [[profile]]
void declare_scene_output(Schema& schema);

/// Opposite corners `low` and `high` of a box in a table of that name, by default the whole grid.
void declare_box(Schema& schema, const std::string& section, const std::string& documentation,
                 const std::vector<Condition>& conditions = {});

/// Conditions between values of a scene.
void check_scene(Schema& schema);

}  // namespace zona::studies
