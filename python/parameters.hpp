// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace limitcurve::python {

namespace nb = nanobind;

/// What a caller gave for the parameters of a function, in their order; None for those that are absent.
struct BoundArguments : std::vector<nb::object> {
  BoundArguments(std::size_t count, const nb::kwargs& keywords) : vector(count), by_name(keywords) {}
  nb::kwargs by_name;  ///< what was given by keyword
};

/// The parameters of a function, by its signature in Python, such as "def gauge(self, force: ArrayLike, *, mu: float =
/// 1.0) -> float".
class Parameters {
 public:
  explicit Parameters(std::string_view signature);
  /// TypeError names the function and the parameter that is unknown, missing or given twice.
  /// `first`: the first positional value that is a parameter's, after self.
  [[nodiscard]] BoundArguments bind(const nb::args& positional, const nb::kwargs& keywords, std::size_t first = 0,
                                    bool has_self = true) const;
  [[nodiscard]] const std::string& function() const { return function_; }
  /// With NumPy's types by their full names.
  [[nodiscard]] const std::string& signature() const { return signature_; }

 private:
  struct Parameter {
    std::string name;
    nb::handle key;  ///< the name as Python has it in calls: one object a text
    bool required;
    bool by_keyword_only;
  };

  [[noreturn]] void refuse(const std::string& what) const;
  [[noreturn]] void refuse_unknown(const std::string& name) const;

  std::string signature_;
  std::string function_;
  std::vector<Parameter> all_;
};

/// Defines a method, of `Self` as nanobind has it (`const Class&`, `Class*` of a constructor):
/// work(self, given), or work(self) of one without parameters.
template <class Self, class Class, class Work>
void define(Class& type, const std::string& signature, const Work& work, const char* doc) {
  const auto parameters = std::make_shared<const Parameters>(signature);
  const auto called = [work](Self self, [[maybe_unused]] const BoundArguments& given) {
    if constexpr (std::is_invocable_v<Work, Self, const BoundArguments&>)
      return work(self, given);
    else
      return std::invoke(work, self);
  };
  const char* const name = parameters->function().c_str();
  if constexpr (std::is_pointer_v<Self>) {
    const auto constructed = [=](Self self, const nb::args& positional, const nb::kwargs& keywords) {
      return called(self, parameters->bind(positional, keywords));
    };
    type.def(name, constructed, nb::sig(parameters->signature().c_str()), doc);
  } else {
    // nanobind's own word on a wrong self, as of Table.gauge(1, 2), would be its lines on C++.
    const auto checked = [=](const nb::args& all, const nb::kwargs& keywords) {
      std::remove_cvref_t<Self>* self = nullptr;
      const bool has_self = all.size() > 0 && nb::try_cast(all[0], self) && self != nullptr;
      const BoundArguments given = parameters->bind(all, keywords, 1, has_self);
      return called(*self, given);
    };
    type.def(name, checked, nb::sig(parameters->signature().c_str()), doc);
  }
}

/// The same of a static method, or with a module in place of the class of a function: work(given).
template <class Type, class Work>
void define_static(Type& type, const std::string& signature, const Work& work, const char* doc) {
  const auto parameters = std::make_shared<const Parameters>(signature);
  const char* const name = parameters->function().c_str();
  const auto called = [parameters, work](const nb::args& positional, const nb::kwargs& keywords) {
    return work(parameters->bind(positional, keywords));
  };
  if constexpr (std::is_same_v<Type, nb::module_>)
    type.def(name, called, nb::sig(parameters->signature().c_str()), doc);
  else
    type.def_static(name, called, nb::sig(parameters->signature().c_str()), doc);
}

}  // namespace limitcurve::python
