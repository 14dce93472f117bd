#pragma once

#include "base/error.h"

#include <pybind11/pybind11.h>

namespace mesher::python {

/// Raises the exception of that name of mesher.errors with the error as its only failure.
[[noreturn]] inline void raise(const char* exception, const Error& error)
{
    namespace py = pybind11;
    py::dict failure;
    failure["entity"] = error.entity;
    failure["point"] = error.point
                           ? py::object(py::make_tuple(error.point->x, error.point->y, error.point->z))
                           : py::object(py::none());
    failure["reason"] = error.message;
    failure["remedy"] = error.remedy;
    py::list failures;
    failures.append(failure);
    const py::object type = py::module_::import("mesher.errors").attr(exception);
    const py::object value = type(describe(error), failures);
    PyErr_SetObject(type.ptr(), value.ptr());
    throw py::error_already_set();
}

}  // namespace mesher::python
