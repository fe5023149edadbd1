#include "parameters.h"

#include "foundation/errors.h"

namespace orogen::python {

namespace {

std::string type_name(const ParameterInfo& info) {
  switch (info.kind) {
    case ParameterKind::Boolean:
      return "bool";
    case ParameterKind::Integer:
      return "int";
    case ParameterKind::Real:
      return "float";
    case ParameterKind::Choice: {
      std::string names;
      for (const auto& name : info.choices) names += (names.empty() ? "'" : ", '") + name + "'";
      return "{" + names + "}";
    }
  }
  return "";
}

std::string shown(const ParameterValue& value) {
  return py::repr(to_python(value)).cast<std::string>();
}

std::string describe(const ParameterInfo& info) {
  std::string text = info.text;
  if (info.kind == ParameterKind::Integer || info.kind == ParameterKind::Real) {
    const std::string unit = info.unit.empty() || info.unit == "1" ? "" : " " + info.unit;
    text += " From " + detail::format_number(info.low) + " to " + detail::format_number(info.high) +
            unit + ".";
  }
  return text;
}

std::string signature(const FunctionDoc& doc) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  for (const Argument& a : doc.arguments)
    add(a.default_value.empty() ? a.name : a.name + "=" + a.default_value);
  if (!doc.parameters.empty()) add("*");
  for (const ParameterInfo& p : doc.parameters) add(p.name + "=" + shown(p.default_value));
  return doc.name + "(" + text + ")";
}

}  // namespace

ParameterValue to_parameter_value(const py::handle& value, const std::string& place) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (PyIndex_Check(value.ptr())) {
    int overflow = 0;
    const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (!number) throw py::error_already_set();
    const long long whole = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
    if (!overflow) return std::int64_t(whole);
  }
  if (PyNumber_Check(value.ptr())) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (!PyErr_Occurred()) return number;
    PyErr_Clear();
  }
  throw InputError(place + ": a " +
                   py::str(py::type::of(value).attr("__name__")).cast<std::string>() +
                   " is not allowed; a number, True, False or text is wanted");
}

py::object to_python(const ParameterValue& value) {
  return std::visit([](const auto& v) -> py::object { return py::cast(v); }, value);
}

py::dict to_dict(const ParameterInfo& info) {
  constexpr const char* kTypes[] = {"bool", "int", "float", "choice"};
  const bool ranged = info.kind == ParameterKind::Integer || info.kind == ParameterKind::Real;
  const auto bound = [&](double value) -> py::object {
    if (!ranged) return py::none();
    if (info.kind == ParameterKind::Integer) return py::int_(std::int64_t(value));
    return py::float_(value);
  };
  py::list choices;
  for (const auto& name : info.choices) choices.append(name);
  py::dict result;
  result["name"] = info.name;
  result["type"] = kTypes[int(info.kind)];
  result["default"] = to_python(info.default_value);
  result["min"] = bound(info.low);
  result["max"] = bound(info.high);
  result["unit"] = info.unit;
  result["description"] = info.text;
  result["choices"] = choices;
  return result;
}

Argument map_argument() {
  return {"map", "VectorMap", "The vector map."};
}
Argument seed_argument() {
  return {"seed", "int", "Seed of everything random.", "0"};
}
Argument threads_argument() {
  return {"threads", "int", "Most threads to use; 0: all cores. The result does not depend on it.",
          "0"};
}
Argument cell_size_argument() {
  return {"cell_size", "float", "Side of a cell in metres."};
}
Argument elevation_argument() {
  return {"elevation", "array (ny, nx) of float32",
          "Height of the ground in metres; row 0 in the south."};
}
Argument base_level_argument() {
  return {"base_level", "array (ny, nx) of bool or int",
          "Not 0 where water leaves (the sea, open sides)."};
}

std::string numpydoc(const FunctionDoc& doc) {
  std::string text = signature(doc) + "\n--\n\n" + doc.summary + "\n\nParameters\n----------\n";
  for (const Argument& a : doc.arguments)
    text += a.name + " : " + a.type + (a.default_value.empty() ? "" : ", optional") + "\n    " +
            a.text + "\n";
  for (const ParameterInfo& p : doc.parameters)
    text += p.name + " : " + type_name(p) + ", default " + shown(p.default_value) + "\n    " +
            describe(p) + "\n";
  text += "\nReturns\n-------\n" + doc.return_type + "\n    " + doc.returns + "\n";
  text +=
      "\nRaises\n------\nInputError\n    An argument has a wrong shape or type, or is out of "
      "range; "
      "nothing was computed.\n";
  if (!doc.citation.empty()) text += "\nReferences\n----------\n" + doc.citation + "\n";
  return text;
}

}  // namespace orogen::python
