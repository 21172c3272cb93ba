// SPDX-License-Identifier: MIT
#include "python/parameters.hpp"

#include "python/core.hpp"

#include "limitcurve/internal/did_you_mean.hpp"

#include <algorithm>

namespace limitcurve::python {

namespace {

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

/// The items between commas that are in no brackets.
std::vector<std::string_view> items_of(std::string_view list) {
  std::vector<std::string_view> items;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= list.size(); ++i) {
    if (i < list.size() && (list[i] == '[' || list[i] == '(')) ++depth;
    if (i < list.size() && (list[i] == ']' || list[i] == ')')) --depth;
    if (i < list.size() && (list[i] != ',' || depth > 0)) continue;
    items.push_back(trimmed(list.substr(begin, i - begin)));
    begin = i + 1;
  }
  return items;
}

}  // namespace

Parameters::Parameters(std::string_view signature) : signature_(signature) {
  constexpr std::string_view type = "ArrayLike";
  for (std::size_t at = 0; (at = signature_.find(type, at)) != std::string::npos;) {
    signature_.insert(at, "numpy.typing.");
    at = signature_.find(type, at) + type.size();
  }
  signature.remove_prefix(signature.find("def ") + 4);
  const std::size_t open = signature.find('(');
  function_ = signature.substr(0, open);
  bool by_keyword_only = false;
  for (const std::string_view item : items_of(signature.substr(open + 1, signature.rfind(") ->") - open - 1))) {
    if (item == "*") {
      by_keyword_only = true;
    } else if (item != "self" && !item.empty()) {
      const std::string name(item.substr(0, item.find(':')));
      all_.push_back({name, PyUnicode_InternFromString(name.c_str()), item.find(" = ") == std::string_view::npos,
                      by_keyword_only});
    }
  }
}

void Parameters::refuse(const std::string& what) const {
  std::string expected;
  for (const Parameter& one : all_) expected += (expected.empty() ? "" : ", ") + one.name;
  if (expected.empty()) expected = "none";
  throw nb::type_error(((function_ == "__init__" ? "" : function_ + ": ") + what + ", expected " + expected).c_str());
}

void Parameters::refuse_unknown(const std::string& name) const {
  std::vector<std::string_view> known;
  for (const Parameter& one : all_) known.push_back(one.name);
  const std::string meant = did_you_mean(name, known);
  refuse("unknown parameter '" + name + "'" + (meant.empty() ? "" : " (" + meant.substr(2) + ")"));
}

BoundArguments Parameters::bind(const nb::args& positional, const nb::kwargs& keywords, std::size_t first,
                                bool has_self) const {
  BoundArguments given(all_.size(), keywords);
  std::size_t next = 0;
  for (std::size_t i = first; i < positional.size(); ++i) {
    if (next == all_.size() || all_[next].by_keyword_only)
      refuse("got " + std::to_string(positional.size() - first) + " values by position");
    given[next++] = positional[i];
  }
  for (const auto& [key, value] : keywords) {
    auto found = std::find_if(all_.begin(), all_.end(), [key = key](const Parameter& one) { return one.key.is(key); });
    if (found == all_.end()) {
      const auto name = nb::cast<std::string>(key);
      found = std::find_if(all_.begin(), all_.end(), [&](const Parameter& one) { return one.name == name; });
      if (found == all_.end()) refuse_unknown(name);
    }
    nb::object& one = given[static_cast<std::size_t>(found - all_.begin())];
    if (one.is_valid()) refuse("'" + found->name + "' twice");
    one = nb::borrow(value);
  }
  if (!has_self) refuse("called on no object of its class");
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (given[i].is_valid()) continue;
    if (all_[i].required) refuse("no '" + all_[i].name + "'");
    given[i] = nb::none();
  }
  return given;
}

}  // namespace limitcurve::python
