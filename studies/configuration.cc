#include "studies/configuration.h"

#include <stdexcept>

namespace zona::studies {

Configuration::Configuration(const Schema& schema, std::filesystem::path file)
    : schema_(&schema), file_(std::move(file)) {}

std::filesystem::path Configuration::base_directory() const {
  return std::filesystem::absolute(file_).parent_path();
}

const Setting& Configuration::setting(const std::string& key) const {
  const auto found = settings_.find(key);
  if (found != settings_.end()) return found->second;
  if (has(key)) throw MissingSetting("the value of " + key + " is invalid");
  throw std::logic_error("a " + kind() + " study has no key " + key);
}

const Setting& Configuration::of_kind(const std::string& key, Parameter::Kind kind,
                                      bool is_list) const {
  const Setting& result = setting(key);
  const Parameter& parameter = *schema_->find(key);
  if (parameter.kind != kind || parameter.is_list != is_list) {
    throw std::logic_error("the key " + key + " is read as the wrong type");
  }
  if (result.is_auto) throw std::logic_error("the key " + key + " is \"auto\"; ask is_auto first");
  return result;
}

double Configuration::quantity(const std::string& key) const {
  return of_kind(key, Parameter::Kind::quantity, false).numbers.front();
}

double Configuration::number(const std::string& key) const {
  return of_kind(key, Parameter::Kind::number, false).numbers.front();
}

long Configuration::integer(const std::string& key) const {
  return static_cast<long>(of_kind(key, Parameter::Kind::integer, false).numbers.front());
}

bool Configuration::boolean(const std::string& key) const {
  return of_kind(key, Parameter::Kind::boolean, false).written.boolean;
}

const std::string& Configuration::choice(const std::string& key) const {
  return of_kind(key, Parameter::Kind::choice, false).texts.front();
}

const std::string& Configuration::text(const std::string& key) const {
  const Setting& result = setting(key);
  if (result.texts.size() != 1) throw std::logic_error("the key " + key + " is not one text");
  return result.texts.front();
}

std::filesystem::path Configuration::path(const std::string& key) const {
  const std::string& name = of_kind(key, Parameter::Kind::file, false).texts.front();
  return name.empty() ? std::filesystem::path() : base_directory() / name;
}

std::vector<double> Configuration::quantities(const std::string& key) const {
  return of_kind(key, Parameter::Kind::quantity, true).numbers;
}

std::vector<double> Configuration::numbers(const std::string& key) const {
  return of_kind(key, Parameter::Kind::number, true).numbers;
}

std::vector<long> Configuration::integers(const std::string& key) const {
  const std::vector<double>& numbers = of_kind(key, Parameter::Kind::integer, true).numbers;
  return {numbers.begin(), numbers.end()};
}

std::vector<std::string> Configuration::texts(const std::string& key) const {
  return setting(key).texts;
}

bool Configuration::is_auto(const std::string& key) const {
  return setting(key).is_auto;
}

bool Configuration::is_default(const std::string& key) const {
  return setting(key).is_default;
}

int Configuration::line_of(const std::string& key) const {
  return setting(key).line;
}

std::string Configuration::where(const std::string& key) const {
  const auto found = settings_.find(key);
  const bool known = found != settings_.end() && !found->second.where.empty();
  return known ? found->second.where : file_.string();
}

void Configuration::set(const std::string& key, Setting setting) {
  settings_[key] = std::move(setting);
}

}  // namespace zona::studies
