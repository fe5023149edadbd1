// Parameter declarations as Python sees them: keyword arguments, dictionaries, docstrings.
#pragma once

#include <pybind11/pybind11.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "foundation/parameters.h"

namespace orogen::python {

namespace py = pybind11;

ParameterValue to_parameter_value(const py::handle& value, const std::string& place);
py::object to_python(const ParameterValue& value);

/// {"name", "type", "default", "min", "max", "unit", "description", "choices"}
py::dict to_dict(const ParameterInfo& info);

/// All declarations of a parameter struct, in order.
template <class P>
py::list schema_of() {
  py::list list;
  for (const ParameterInfo& info : describe_parameters<P>()) list.append(to_dict(info));
  return list;
}

/// A parameter struct from keyword arguments.
template <class P>
P from_keywords(const py::kwargs& keywords) {
  P result;
  for (const auto& [key, value] : keywords) {
    const auto name = py::cast<std::string>(key);
    set_parameter(result, name, to_parameter_value(value, name));
  }
  return result;
}

struct Argument {
  std::string name, type, text;
  std::string default_value = "";  // empty: must be given
};

/// Arguments that many functions have.
Argument map_argument();
Argument seed_argument();
Argument threads_argument();
Argument cell_size_argument();
Argument elevation_argument();
Argument base_level_argument();

/// What a numpydoc docstring is made of. Its first line is the signature, which Python's `inspect`
/// understands.
struct FunctionDoc {
  std::string name = "", summary = "";
  std::vector<Argument> arguments = {};
  std::vector<ParameterInfo> parameters = {};  // keyword-only
  std::string return_type = "", returns = "";
  std::string citation = "";
};

std::string numpydoc(const FunctionDoc& doc);

/// Defines a function with its docstring and nothing else in it.
template <class Function, class... Extra>
void define(py::module_& module, const FunctionDoc& doc, Function&& function,
            const Extra&... extra) {
  py::options options;
  options.disable_function_signatures();
  module.def(doc.name.c_str(), std::forward<Function>(function), extra..., numpydoc(doc).c_str());
}

}  // namespace orogen::python
