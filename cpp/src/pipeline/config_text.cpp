// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <sstream>
#include <tuple>

#include "core/options_json.hpp"
#include "survtrack/pipeline/config.hpp"

/// The texts made from fields(): a commented TOML file of a config, and the reference page of all options.
namespace survtrack {
namespace {

template <class Value>
constexpr bool is_table = is_variant<Value>::value || has_fields<Value>::value;

template <class Value>
std::string allowed(const Bounds& bounds) {
  if constexpr (std::is_enum_v<Value>) {
    std::string text;
    for (const auto& [name, choice] : enum_names(Value{})) {
      static_cast<void>(choice);
      text += (text.empty() ? "" : ", ") + std::string(name);
    }
    return text;
  } else if constexpr (std::is_same_v<Value, bool>) {
    return "true, false";
  } else if constexpr (is_number_list<Value>::value) {
    return describe(bounds, std::tuple_size_v<Value>);
  } else {
    return describe(bounds);
  }
}

template <class Struct>
void write_values(std::ostream& out, const Struct& options) {
  for_each_field<Struct>([&](const auto& f) {
    using Value = typename std::decay_t<decltype(f)>::value_type;
    if constexpr (!is_table<Value>) {
      out << f.name << " = " << options_json::value_to_json(options.*(f.member)).dump() << "  # ";
      if (*f.unit != '\0') out << f.unit << "; ";
      out << f.meaning << "\n";
    }
  });
}

template <class Struct>
void write_toml(std::ostream& out, const Struct& options, const std::string& path) {
  write_values(out, options);
  for_each_field<Struct>([&](const auto& f) {
    using Value = typename std::decay_t<decltype(f)>::value_type;
    if constexpr (is_table<Value>) {
      const std::string inner = join_path(path, f.name);
      out << "\n[" << inner << "]  # " << f.meaning << "\n";
      if constexpr (is_variant<Value>::value) {
        std::visit(
            [&](const auto& alternative) {
              out << "model = \"" << alternative.model << "\"  # " << alternative.meaning << "\n";
              write_toml(out, alternative, inner);
            },
            options.*(f.member));
      } else {
        write_toml(out, options.*(f.member), inner);
      }
    }
  });
}

template <class Struct>
void write_rows(std::ostream& out, const std::string& path) {
  const Struct defaults;
  bool any = false;
  for_each_field<Struct>([&](const auto& f) {
    using Value = typename std::decay_t<decltype(f)>::value_type;
    if constexpr (!is_table<Value>) {
      if (!any) out << "\n| option | default | unit | allowed | meaning |\n|---|---|---|---|---|\n";
      any = true;
      out << "| `" << join_path(path, f.name) << "` | `" << options_json::value_to_json(defaults.*(f.member)).dump()
          << "` | " << f.unit << " | " << allowed<Value>(f.bounds) << " | " << f.meaning << " |\n";
    }
  });
  if (!any) out << "\nNo options.\n";
}

template <class Struct>
void write_sections(std::ostream& out, const std::string& path);

template <class Variant, std::size_t... I>
void write_models(std::ostream& out, const std::string& path, std::index_sequence<I...>) {
  const auto write = [&](auto alternative) {
    using Alternative = decltype(alternative);
    out << "\n### `" << path << ".model = \"" << Alternative::model << "\"`\n\n" << Alternative::meaning << ".\n";
    write_rows<Alternative>(out, path);
    write_sections<Alternative>(out, path);
  };
  (write(std::variant_alternative_t<I, Variant>{}), ...);
}

template <class Struct>
void write_sections(std::ostream& out, const std::string& path) {
  for_each_field<Struct>([&](const auto& f) {
    using Value = typename std::decay_t<decltype(f)>::value_type;
    if constexpr (is_table<Value>) {
      const std::string inner = join_path(path, f.name);
      out << "\n## `[" << inner << "]`\n\n" << f.meaning << ".\n";
      if constexpr (is_variant<Value>::value) {
        write_models<Value>(out, inner, std::make_index_sequence<std::variant_size_v<Value>>{});
      } else {
        write_rows<Value>(out, inner);
        write_sections<Value>(out, inner);
      }
    }
  });
}

}  // namespace

std::string Config::to_toml() const {
  std::ostringstream out;
  write_toml(out, *this, "");
  return out.str();
}

std::string options_reference() {
  std::ostringstream out;
  out << "# Options\n\nEvery option of a config, made from the library itself. The first model of each section is the "
         "default.\n\n## Config\n";
  write_rows<Config>(out, "");
  write_sections<Config>(out, "");
  return out.str();
}

}  // namespace survtrack
