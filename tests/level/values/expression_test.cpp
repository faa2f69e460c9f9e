#include "level/values/expression.h"

#include <doctest/doctest.h>

#include "geometry/elementary.h"

using namespace carom;

namespace {

std::optional<Value> value_of(const std::string& text, LengthUnit unit = LengthUnit::natural) {
    SourceText source;
    source.text = text;
    source.lines = {source.text};
    Scope scope;
    scope.names["W"] = {Value{10.0, {}}, {}, nullptr};
    scope.names["faulty"] = {std::nullopt, {}, nullptr};
    Reporter reporter;
    const auto value = evaluate({source.text, &source, 1, 1}, scope, {unit, nullptr}, reporter);
    CHECK((value.has_value() || reporter.has_errors() || text.find("faulty") != text.npos));
    return value;
}

double number(const std::string& text, LengthUnit unit = LengthUnit::natural) {
    CAPTURE(text);
    const auto value = value_of(text, unit);
    REQUIRE(value);
    return value->number;
}

}  // namespace

TEST_CASE("operators have the usual precedence") {
    CHECK(number("1+2*3") == 7.0);
    CHECK(number("(1+2)*3") == 9.0);
    CHECK(number("10-4-3") == 3.0);
    CHECK(number("24/4/3") == 2.0);
    CHECK(number("2^3^2") == 512.0);
    CHECK(number("-2^2") == -4.0);
    CHECK(number("2^-1") == 0.5);
    CHECK(number("2*-3") == -6.0);
    CHECK(number("--3") == 3.0);
    CHECK(number("+3") == 3.0);
    CHECK(number("W/2-1") == 4.0);
    CHECK(number("100^7") == 1e14);
    CHECK(number("9^0.5") == 3.0);
    CHECK(number(".5") == 0.5);
    CHECK(number("1e-3") == 0.001);
    CHECK(number("2E2") == 200.0);
    CHECK(number("0.1") == 0.1);
}

TEST_CASE("functions take degrees, and are exact at right angles") {
    CHECK(number("sqrt(16)") == 4.0);
    CHECK(number("sin(90)") == 1.0);
    CHECK(number("cos(90)") == 0.0);
    CHECK(number("sin(30)") == doctest::Approx(0.5));
    CHECK(number("tan(45)") == doctest::Approx(1.0));
    CHECK(number("abs(-3)") == 3.0);
    CHECK(number("min(2,1)+max(2,1)") == 3.0);
    CHECK(number("floor(-1.5)") == -2.0);
    CHECK(number("ceil(-1.5)") == -1.0);
    CHECK(number("round(2.5)") == 3.0);
    CHECK(number("pi") == pi);
}

TEST_CASE("units convert and combine in a level with units") {
    using enum LengthUnit;
    CHECK(number("3cm", millimetre) == doctest::Approx(0.03));
    CHECK(number("3mm+2", millimetre) == doctest::Approx(0.005));
    CHECK(number("2+3mm", centimetre) == doctest::Approx(0.023));
    CHECK(number("9.81m/s2", millimetre) == 9.81);
    CHECK(number("3mm*2", millimetre) == doctest::Approx(0.006));
    CHECK(number("1rad", millimetre) == doctest::Approx(180.0 / pi));
    CHECK(value_of("6mm/2mm", millimetre)->is_bare());
    CHECK(value_of("sqrt(4mm*4mm)", millimetre)->dimension == Dimension{1, 0, 0, 0});
    CHECK(value_of("(2m/s)^2", millimetre)->dimension == Dimension{2, 0, -2, 0});
    CHECK(value_of("5/s", millimetre)->dimension == Dimension{0, 0, -1, 0});
    CHECK(value_of("1kg/m2", millimetre)->dimension == Dimension{-2, 1, 0, 0});
    CHECK(number("50ms") == 0.05);
    CHECK(number("2min") == 120.0);
    CHECK(number("min(2s,1)") == 1.0);
}

TEST_CASE("a let named s hides the unit after a bare number, and only there") {
    SourceText source;
    source.text = "10/s 10m/s";
    source.lines = {source.text};
    Scope scope;
    scope.names["s"] = {Value{2.0, {}}, {}, nullptr};
    Reporter reporter;
    const ExpressionRules rules{LengthUnit::millimetre, nullptr};
    const Word all{source.text, &source, 1, 1};
    CHECK(evaluate(all.part(0, 4), scope, rules, reporter)->number == 5.0);
    CHECK(evaluate(all.part(5), scope, rules, reporter)->dimension == Dimension{1, 0, -1, 0});
}

TEST_CASE("exponents of units are bounded") {
    CHECK(value_of("(1m)^99", LengthUnit::metre));
    CHECK_FALSE(value_of("(1m)^100", LengthUnit::metre));
    CHECK_FALSE(value_of("(((1m)^99)^1000)^1000", LengthUnit::metre));
}

TEST_CASE("the use of an error value is not reported") {
    SourceText source;
    source.text = "faulty*2";
    source.lines = {source.text};
    Scope scope;
    scope.names["faulty"] = {std::nullopt, {}, nullptr};
    Reporter reporter;
    CHECK_FALSE(evaluate({source.text, &source, 1, 1}, scope, {}, reporter));
    CHECK_FALSE(reporter.has_errors());
}
