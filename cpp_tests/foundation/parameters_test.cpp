#include "foundation/parameters.h"

#include <gtest/gtest.h>

#include <limits>

namespace orogen {
namespace {

enum class Mode { Slow, Fast };
constexpr std::string_view kModes[] = {"slow", "fast"};

struct Sample {
  double length = 2.5;
  int count = 3;
  bool on = true;
  Mode mode = Mode::Fast;
};

constexpr auto parameter_table(const Sample*) {
  return std::tuple{real("length", &Sample::length, 0.5, 10.0, "m", "A length."),
                    integer("count", &Sample::count, 1, 9, "", "A count."),
                    boolean("on", &Sample::on, "A switch."),
                    choice("mode", &Sample::mode, kModes, "A mode.")};
}

std::string message_of(std::string_view name, const ParameterValue& value) {
  Sample sample;
  try {
    set_parameter(sample, name, value, "stages[1]");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Parameters, DescribesEachDeclarationWithItsDefault) {
  const auto infos = describe_parameters<Sample>();
  ASSERT_EQ(infos.size(), 4u);
  EXPECT_EQ(infos[0].name, "length");
  EXPECT_EQ(std::get<double>(infos[0].default_value), 2.5);
  EXPECT_EQ(infos[0].unit, "m");
  EXPECT_EQ(std::get<std::int64_t>(infos[1].default_value), 3);
  EXPECT_EQ(infos[3].choices, (std::vector<std::string>{"slow", "fast"}));
  EXPECT_EQ(std::get<std::string>(infos[3].default_value), "fast");
}

TEST(Parameters, SetsByName) {
  Sample sample;
  set_parameter(sample, "length", std::int64_t{4});
  set_parameter(sample, "count", 5.0);
  set_parameter(sample, "on", false);
  set_parameter(sample, "mode", std::string("slow"));
  EXPECT_EQ(sample.length, 4.0);
  EXPECT_EQ(sample.count, 5);
  EXPECT_FALSE(sample.on);
  EXPECT_EQ(sample.mode, Mode::Slow);
}

TEST(Parameters, RefusalNamesFieldPlaceAndRange) {
  EXPECT_EQ(message_of("length", 11.0),
            "stages[1].length: 11 is not allowed; a number from 0.5 to 10 m is wanted");
  EXPECT_EQ(message_of("count", 2.5),
            "stages[1].count: 2.5 is not allowed; a whole number from 1 to 9 is wanted");
  EXPECT_EQ(message_of("mode", std::string("x")),
            "stages[1].mode: 'x' is not allowed; one of slow, fast is wanted");
  EXPECT_NE(message_of("size", 1.0).find("there are length, count, on, mode"), std::string::npos);
  EXPECT_NE(message_of("on", 1.0), "");
  EXPECT_NE(message_of("length", std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_NE(message_of("length", std::numeric_limits<double>::infinity()), "");
}

TEST(Parameters, CheckFindsAValueSetFromCpp) {
  Sample sample;
  EXPECT_NO_THROW(check_parameters(sample));
  sample.count = 10;
  EXPECT_THROW(check_parameters(sample), InputError);
}

}  // namespace
}  // namespace orogen
