// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace limitcurve::python {

namespace nb = nanobind;

/// What a caller gave for the parameters of a function, in their order; None for those that are absent.
using Given = std::vector<nb::object>;

/// The parameters of a function, by its signature in Python, such as "def gauge(self, force: float, *, mu: float = 1.0) -> float".
class Parameters {
 public:
  explicit Parameters(std::string_view signature);
  /// TypeError names the function and the parameter that is unknown, missing or given twice.
  [[nodiscard]] Given bind(const nb::args& positional, const nb::kwargs& keywords) const;
  [[nodiscard]] const std::string& function() const { return function_; }

 private:
  struct Parameter {
    std::string name;
    bool required;
    bool by_keyword_only;
  };
  [[noreturn]] void refuse(const std::string& what) const;

  std::string function_;
  std::vector<Parameter> all_;
};

/// Defines a method, of `Self` as nanobind has it (`const Class&`, `Class*` of a constructor): work(self, given).
template <class Self, class Class, class Work>
void define(Class& type, const char* signature, const Work& work, const char* doc) {
  const auto parameters = std::make_shared<const Parameters>(signature);
  type.def(
      parameters->function().c_str(),
      [parameters, work](Self self, const nb::args& positional, const nb::kwargs& keywords) {
        return work(self, parameters->bind(positional, keywords));
      },
      nb::sig(signature), doc);
}

/// The same of a static method, or with a module in place of the class of a function: work(given).
template <class Class, class Work>
void define_static(nb::class_<Class>& type, const char* signature, const Work& work, const char* doc) {
  const auto parameters = std::make_shared<const Parameters>(signature);
  type.def_static(
      parameters->function().c_str(),
      [parameters, work](const nb::args& positional, const nb::kwargs& keywords) { return work(parameters->bind(positional, keywords)); },
      nb::sig(signature), doc);
}
template <class Work>
void define_static(nb::module_& module, const char* signature, const Work& work, const char* doc) {
  const auto parameters = std::make_shared<const Parameters>(signature);
  module.def(
      parameters->function().c_str(),
      [parameters, work](const nb::args& positional, const nb::kwargs& keywords) { return work(parameters->bind(positional, keywords)); },
      nb::sig(signature), doc);
}

}  // namespace limitcurve::python
