// SPDX-License-Identifier: MIT
// Questions that every interface answers alike (data/conformance.csv, from a reference that is not the library): C++
// exact, in double and in float, and C. tests/cli/test_conformance.py asks the command and the exported header,
// python/tests/test_conformance.py the rest.
#include "c/limitcurve.h"

#include "godobject/finger_curve.hpp"
#include "godobject/friction.hpp"
#include "limitcurve/contact/load_to_hold.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace limitcurve {
namespace {

using namespace godobject;
using Numbers = std::vector<double>;

struct Question {
  int line = 0;
  std::string quantity;
  std::string law;
  std::string radius_law;  ///< of hold and margin
  Numbers arguments;
  Numbers answer;
};

std::vector<Question> questions() {
  std::ifstream file(LIMITCURVE_DATA_DIR "/conformance.csv");
  std::vector<Question> result;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (line.starts_with('#') || line.starts_with("quantity,")) continue;
    std::istringstream cells(line);
    Question question{number, "", "", "", {}, {}};
    std::string arguments, answer;
    std::getline(cells, question.quantity, ',');
    std::getline(cells, question.law, ',');
    // A radius law has commas.
    const bool is_quoted = cells.peek() == '"';
    if (is_quoted) cells.ignore();
    std::getline(cells, arguments, is_quoted ? '"' : ',');
    if (is_quoted) cells.ignore();
    std::getline(cells, answer);
    const auto read = [&question](const std::string& text, Numbers& numbers) {
      std::istringstream words(text);
      for (std::string word; words >> word;) {
        word.find(':') != std::string::npos ? void(question.radius_law = word)
                                            : numbers.push_back(std::strtod(word.c_str(), nullptr));
      }
    };
    read(arguments, question.arguments);
    read(answer, question.answer);
    result.push_back(question);
  }
  return result;
}

/// One interface: what it answers to a question; nothing if it has no such question, an empty list if it refuses.
struct Interface {
  const char* name;
  double tolerance;  ///< of unit wrenches; gauges and loads have it relative to the lesser of f and m's units
  std::function<std::optional<Numbers>(const Question&)> answer;
};

/// What any curve answers.
template <class Curve>
std::optional<Numbers> of_curve(const Curve& curve, const Question& question) {
  const Numbers& of = question.arguments;
  if (question.quantity == "wrench") {
    const UnitWrench wrench = curve.wrench({of[0], of[1]});
    return Numbers{wrench.force, wrench.moment};
  }
  if (question.quantity == "gauge") return Numbers{curve.gauge({of[0], of[1]})};
  if (question.quantity == "hold")
    return Numbers{load_to_hold(curve, {of[0], RadiusLaw::parse(question.radius_law)}, of[1], of[2])};
  return std::nullopt;
}

template <class Real>
std::optional<Numbers> of_finger_curve(const BasicFingerCurve<Real>& curve, const Question& question) {
  const Numbers& of = question.arguments;
  if (question.quantity != "closest") return of_curve(curve, question);
  // What is not finite is the loop's business; a fraction of a longer trial underflows.
  constexpr double longest = sizeof(Real) == sizeof(double) ? 1e300 : 1e30;
  if (!(std::hypot(of[0], of[1]) <= 2.0 * longest && std::isfinite(of[2]))) return std::nullopt;
  const auto real = [](double value) { return static_cast<Real>(value); };
  const FrictionLimit<Real> limit{1, 1};
  FrictionMemory<Real> memory;
  const auto result =
      apply_friction(curve.view(), Projection::closest_point, FrictionLimits<Real>{limit, limit, real(of[2])},
                     FrictionTrial<Real>{real(of[0]), real(of[1])}, memory);
  return Numbers{double{result.force_fraction} * of[0], double{result.moment_fraction} * of[1]};
}

std::optional<Numbers> of_c(const limitcurve_table* table, const Question& question) {
  const Numbers& of = question.arguments;
  double result = 0.0;
  limitcurve_status status = LIMITCURVE_OK;
  if (question.quantity == "gauge") {
    status = limitcurve_table_gauge(table, &of[0], &of[1], 1, &result);
  } else if (question.quantity == "hold") {
    limitcurve_finger_parameters contact = limitcurve_finger_defaults();
    contact.mu = of[0];
    contact.radius_law = question.radius_law.c_str();
    status = limitcurve_table_load_to_hold(table, &contact, &of[1], &of[2], 1, &result);
  } else if (question.quantity == "closest") {
    const limitcurve_limits limits{1, 1, 1, 1, of[2], 1, 1};
    limitcurve_memory memory{};
    limitcurve_friction friction{};
    status = limitcurve_apply_friction(table, LIMITCURVE_CLOSEST_POINT, &limits, of[0], of[1], &memory, &friction);
    if (status == LIMITCURVE_OK) return Numbers{friction.force_fraction * of[0], friction.moment_fraction * of[1]};
  } else {
    return std::nullopt;
  }
  return status == LIMITCURVE_OK ? Numbers{result} : Numbers{};
}

TEST(Questions, EveryInterfaceAnswersAlike) {
  const std::vector<Question> all = questions();
  ASSERT_GT(all.size(), 250U);
  std::map<std::string, std::vector<Interface>> interfaces;
  std::map<std::string, int> asked;
  for (const Question& question : all) {
    auto& of_law = interfaces[question.law];
    if (of_law.empty()) {
      const Law law = parse_law(question.law);
      const ExactCurve exact(law);
      const Table table = Table::build(law, 1e-9);
      const FloatTable single = FloatTable::build(law, 2e-6);
      limitcurve_law* c_law = nullptr;
      limitcurve_table* c_table = nullptr;
      ASSERT_EQ(limitcurve_law_parse(question.law.c_str(), &c_law), LIMITCURVE_OK);
      ASSERT_EQ(limitcurve_table_build(c_law, 1e-9, &c_table), LIMITCURVE_OK);
      limitcurve_law_free(c_law);
      const std::shared_ptr<limitcurve_table> owned(c_table, limitcurve_table_free);
      of_law = {
          {"ExactCurve", 5e-12, [exact](const Question& q) { return of_curve(exact, q); }},
          {"Table", 2e-9, [table](const Question& q) { return of_curve(table, q); }},
          {"FloatTable", 4e-6, [single](const Question& q) { return of_curve(single, q); }},
          {"FingerCurve", 2e-9, [curve = FingerCurve(table)](const Question& q) { return of_finger_curve(curve, q); }},
          {"FingerCurve in float", 4e-6,
           [curve = BasicFingerCurve<float>(single)](const Question& q) { return of_finger_curve(curve, q); }},
          {"C", 2e-9, [owned](const Question& q) { return of_c(owned.get(), q); }}};
    }
    // Errors of a table are in units of the larger of 1 and m₀.
    const double ratio = ExactCurve(parse_law(question.law)).moment_ratio();
    const double unit = std::max(ratio, 1.0 / ratio);
    const bool is_finite =
        std::all_of(question.arguments.begin(), question.arguments.end(), [](double x) { return std::isfinite(x); });
    for (const Interface& one : of_law) {
      const auto answer = one.answer(question);
      if (!answer) continue;
      ++asked[one.name];
      const std::string place = "conformance.csv:" + std::to_string(question.line) + ' ' + one.name;
      if (answer->empty()) {
        EXPECT_FALSE(is_finite) << place << " refuses";
        continue;
      }
      for (std::size_t i = 0; i < question.answer.size(); ++i) {
        const double expected = question.answer[i];
        const double got = (*answer)[i];
        if (!std::isfinite(expected)) {
          EXPECT_TRUE(std::isnan(expected) ? std::isnan(got) : got == expected)
              << place << " got " << got << " for " << expected;
        } else {
          EXPECT_NEAR(got, expected, one.tolerance * unit * std::max(1.0, std::fabs(expected))) << place;
        }
      }
    }
  }
  EXPECT_EQ(asked.size(), 6U);
}

}  // namespace
}  // namespace limitcurve
