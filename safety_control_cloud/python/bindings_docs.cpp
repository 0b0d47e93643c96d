// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <cstring>
#include <docstrings.hpp>
#include <string>

#include "bindings.hpp"

namespace bindings {
namespace {

/// The function itself, of a method or a static one.
py::object function_in(const py::object& member) {
  if (PyInstanceMethod_Check(member.ptr()))
    return py::reinterpret_borrow<py::object>(PyInstanceMethod_GET_FUNCTION(member.ptr()));
  return py::hasattr(member, "__func__") ? py::object(member.attr("__func__")) : member;
}

/// Below the signature that pybind11 has written there, and in its way: it frees what it finds at the end.
void append(const py::object& function, const char* text) {
  auto* definition = reinterpret_cast<PyCFunctionObject*>(function.ptr())->m_ml;
  const std::string whole = std::string(definition->ml_doc ? definition->ml_doc : "") + "\n" + text;
  std::free(const_cast<char*>(definition->ml_doc));
  definition->ml_doc = strdup(whole.c_str());
}

}  // namespace

void document(py::module& module) {
  for (const auto& [owner, name, text] : docstrings) {
    const py::object holder = *owner ? py::object(module.attr(owner)) : py::object(module);
    const py::dict members(holder.attr("__dict__"));
    if (!members.contains(name)) continue;
    const py::object member = function_in(py::object(members[name]));
    if (PyCFunction_Check(member.ptr())) {
      append(member, text);
    } else if (PyType_Check(member.ptr())) {
      // An enumeration's own way would refuse.
      if (PyType_Type.tp_setattro(member.ptr(), py::str("__doc__").ptr(), py::str(text).ptr()) != 0)
        throw py::error_already_set();
    } else {
      py::setattr(member, "__doc__", py::str(text));
    }
  }
}

}  // namespace bindings
