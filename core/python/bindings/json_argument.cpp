#include "json_argument.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "foundation/errors.h"
#include "foundation/parameters.h"

namespace orogen::python {

namespace {

constexpr int kDeepest = 64;

[[noreturn]] void refuse(const std::string& place, const std::string& what) {
  throw InputError(place + ": " + what + " is not allowed");
}

nlohmann::json convert(const py::handle& value, const std::string& place, int depth) {
  if (depth > kDeepest) refuse(place, "nesting deeper than " + std::to_string(kDeepest));
  if (value.is_none()) return nullptr;
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::hasattr(value, "tolist")) return convert(value.attr("tolist")(), place, depth + 1);
  if (PyLong_Check(value.ptr())) {
    int overflow = 0;
    const long long whole = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
    if (overflow) refuse(place, py::repr(value).cast<std::string>());
    return whole;
  }
  if (PyFloat_Check(value.ptr())) {
    const double number = value.cast<double>();
    if (!std::isfinite(number)) refuse(place, detail::format_number(number));
    return number;
  }
  if (py::isinstance<py::dict>(value)) {
    auto object = nlohmann::json::object();
    for (const auto& [key, item] : value.cast<py::dict>()) {
      const auto name = py::str(key).cast<std::string>();
      object[name] = convert(item, place + "." + name, depth + 1);
    }
    return object;
  }
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    auto array = nlohmann::json::array();
    for (const py::handle item : value.cast<py::sequence>())
      array.push_back(convert(item, place + "[" + std::to_string(array.size()) + "]", depth + 1));
    return array;
  }
  refuse(place, "a " + py::str(py::type::of(value).attr("__name__")).cast<std::string>());
}

}  // namespace

nlohmann::json to_json(const py::handle& value, const std::string& place) {
  return convert(value, place, 0);
}

py::object from_json(const nlohmann::json& document) {
  return py::module_::import("json").attr("loads")(document.dump());
}

}  // namespace orogen::python
