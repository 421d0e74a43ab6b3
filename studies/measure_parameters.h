#pragma once

#include "studies/configuration.h"
#include "studies/schema.h"

namespace zona::studies {

/// Opposite corners `low` and `high` of a box in a table of that name, by default the whole grid.
void declare_box(Schema& schema, const std::string& section, const std::string& documentation,
                 const std::vector<Condition>& conditions = {});

/// Complains of a box whose corners are the wrong way round, or at one place unless it may be flat.
void check_box(const Table& table, const Complain& complain, bool may_be_flat);

/// [[probe]], [[profile]] and [[section]] of a scene, whose bodies are its [[body]].
void declare_scene_measures(Schema& schema);

/// The same of a piercing, whose bodies have fixed names and whose places count from the middle of
/// the egg.
void declare_piercing_measures(Schema& schema);

}  // namespace zona::studies
