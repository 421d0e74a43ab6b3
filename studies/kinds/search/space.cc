#include "studies/kinds/search/space.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <type_traits>

#include "studies/input/interpret.h"
#include "studies/input/units.h"
#include "studies/kinds/search/variable_table.h"

namespace zona::studies::search {

namespace {

/// The unit of a quantity as it is written: "us" of "20 us".
std::string unit_of(const TomlValue& value) {
  if (value.type != TomlValue::Type::text) return "";
  char* end = nullptr;
  std::strtod(value.text.c_str(), &end);
  const std::string unit = end;
  const std::size_t first = unit.find_first_not_of(' ');
  return first == std::string::npos ? "" : unit.substr(first);
}

/// Reads a table that is bound to T, a Varied; gathers what is wrong with it.
template <class T>
class Reader {
 public:
  Reader(const Table& table, const Configuration& base, std::vector<Problem>& problems)
      : table_(table), varied_(table.read<T>()), base_(base), problems_(problems) {}

  Dimension read() {
    Dimension dimension;
    dimension.name = table_.name();
    dimension.key = varied_.key;
    dimension.is_logarithmic = varied_.scale == Scale::logarithmic;
    if constexpr (std::is_same_v<T, Uncertain>) dimension.source = varied_.source;
    const Parameter* parameter = base_.schema().find(dimension.key);
    if (parameter == nullptr || parameter->is_list || !base_.applies(dimension.key)) {
      complain(&Varied::key,
               fmt::format("\"{}\" is no key with one value of the {} study {}; \"zona "
                           "help {}\" lists them",
                           printable(dimension.key), base_.kind(), base_.file().filename().string(),
                           base_.kind()));
      return dimension;
    }
    const bool has_list = !varied_.values.empty();
    if (has_list == !varied_.range.empty()) {
      complain(has_list ? &Varied::values : &Varied::range,
               "needs either values = [...] or range = [lowest, highest]");
    } else if (has_list) {
      take_list(dimension, *parameter);
    } else {
      take_range(dimension, *parameter);
    }
    return dimension;
  }

 private:
  template <class M>
  void complain(M Varied::*member, const std::string& message) {
    problems_.push_back(table_.problem(static_cast<M T::*>(member), message));
  }

  /// The value in SI, or a complaint.
  double interpreted(const Parameter& parameter, const TomlValue& value,
                     std::vector<TomlValue> Varied::*member) {
    std::vector<std::string> messages;
    const Setting setting = interpret(parameter, value, messages);
    for (const std::string& message : messages) complain(member, message);
    return setting.numbers.empty() ? 0 : setting.numbers.front();
  }

  void take_list(Dimension& dimension, const Parameter& parameter) {
    for (const TomlValue& value : varied_.values) {
      interpreted(parameter, value, &Varied::values);
      dimension.values.push_back(value.written());
    }
  }

  void take_range(Dimension& dimension, const Parameter& parameter) {
    const auto& range = varied_.range;
    const bool is_number =
        parameter.kind == Parameter::Kind::quantity || parameter.kind == Parameter::Kind::number;
    if (!is_number || range.size() != 2) {
      complain(&Varied::range, is_number
                                   ? "needs two values, the lowest and the highest"
                                   : "is for quantities and numbers; list the values instead");
      return;
    }
    const double low = interpreted(parameter, range[0], &Varied::range);
    const double high = interpreted(parameter, range[1], &Varied::range);
    if (!(low < high) || (dimension.is_logarithmic && !(low > 0))) {
      complain(&Varied::range, dimension.is_logarithmic
                                   ? "needs a lowest value above zero and a greater highest one"
                                   : "needs a lowest and a greater highest value");
      return;
    }
    try {
      dimension.unit = unit_of(range[0]);
      const double one = parameter.kind == Parameter::Kind::quantity
                             ? parse_quantity("1 " + dimension.unit, parameter.unit)
                             : 1;
      dimension.low = low / one;
      dimension.high = high / one;
    } catch (const UnitError&) {
      complain(&Varied::range, "needs numbers with units, not names; list names as values");
    }
  }

  const Table& table_;
  T varied_;
  const Configuration& base_;
  std::vector<Problem>& problems_;
};

}  // namespace

double Dimension::value(double share) const {
  const double exact =
      is_logarithmic ? low * std::pow(high / low, share) : low + (high - low) * share;
  return std::stod(fmt::format("{:.4g}", exact));
}

std::string Dimension::at(double share) const {
  const std::string number = fmt::format("{:g}", value(share));
  return key + "=" + (unit.empty() ? number : "\"" + number + " " + unit + "\"");
}

std::string Dimension::choose(std::size_t number) const {
  return key + "=" + values.at(number);
}

template <class T>
std::vector<Dimension> dimensions_from(const Configuration& search, const Configuration& base) {
  std::vector<Dimension> dimensions;
  std::vector<Problem> problems;
  for (const Table& table : search.items<T>()) {
    Dimension dimension = Reader<T>(table, base, problems).read();
    for (const Dimension& other : dimensions)
      if (other.key == dimension.key)
        problems.push_back(table.problem(static_cast<std::string T::*>(&Varied::key),
                                         "is varied twice; once is enough"));
    dimensions.push_back(std::move(dimension));
  }
  if (!problems.empty()) throw InputError(problems);
  return dimensions;
}

template std::vector<Dimension> dimensions_from<Variable>(const Configuration&,
                                                          const Configuration&);
template std::vector<Dimension> dimensions_from<Uncertain>(const Configuration&,
                                                           const Configuration&);

std::vector<std::vector<double>> latin_hypercube(std::size_t dimensions, std::size_t samples,
                                                 std::uint64_t seed) {
  // Distributions and shuffles of the standard library differ from one to the next.
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<std::vector<double>> points(samples, std::vector<double>(dimensions));
  std::vector<std::size_t> layer(samples);
  for (std::size_t d = 0; d < dimensions; ++d) {
    for (std::size_t i = 0; i < samples; ++i) layer[i] = i;
    for (std::size_t i = samples; i > 1; --i)
      std::swap(layer[i - 1], layer[static_cast<std::size_t>(uniform() * static_cast<double>(i))]);
    for (std::size_t i = 0; i < samples; ++i)
      points[i][d] = (static_cast<double>(layer[i]) + uniform()) / static_cast<double>(samples);
  }
  return points;
}

std::vector<std::vector<std::size_t>> combinations(const std::vector<Dimension>& dimensions) {
  std::vector<std::vector<std::size_t>> all{{}};
  for (const Dimension& dimension : dimensions) {
    if (!dimension.is_list()) continue;
    std::vector<std::vector<std::size_t>> longer;
    for (const auto& combination : all)
      for (std::size_t value = 0; value < dimension.values.size(); ++value) {
        longer.push_back(combination);
        longer.back().push_back(value);
      }
    all = std::move(longer);
  }
  return all;
}

std::string key_of(const std::string& entry) {
  return entry.substr(0, entry.find('='));
}

Overrides overrides_at(const std::vector<Dimension>& dimensions,
                       const std::vector<std::size_t>& combination,
                       const std::vector<double>& place) {
  Overrides overrides;
  std::size_t list = 0, range = 0;
  for (const Dimension& dimension : dimensions)
    overrides.push_back(dimension.is_list() ? dimension.choose(combination[list++])
                                            : dimension.at(place[range++]));
  return overrides;
}

std::string shown_value(const std::string& entry) {
  std::string value = entry.substr(entry.find('=') + 1);
  if (value.size() >= 2 && value.front() == '"') value = value.substr(1, value.size() - 2);
  return value;
}

}  // namespace zona::studies::search
