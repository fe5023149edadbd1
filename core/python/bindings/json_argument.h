// Parts of recipes as arguments: dictionaries and lists that the core reads as JSON.
#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace orogen::python {

namespace py = pybind11;

/// Dictionaries, lists, numbers and text as JSON; arrays are lists. InputError, beginning with
/// `place`, for anything else and for numbers that are not finite.
nlohmann::json to_json(const py::handle& value, const std::string& place);

py::object from_json(const nlohmann::json& document);

}  // namespace orogen::python
