#pragma once

#include <string>
#include <vector>

#include "studies/input/configuration.h"

namespace zona::studies {

/// Checks a value against its declaration and converts it to SI. Adds one message per problem
/// ("what is wrong; what is allowed; what to do"); the setting is meaningful when there is none.
Setting interpret(const Parameter& parameter, const TomlValue& value,
                  std::vector<std::string>& messages);

/// The default of a parameter. Throws std::logic_error when its declaration is inconsistent.
Setting default_setting(const Parameter& parameter);

}  // namespace zona::studies
