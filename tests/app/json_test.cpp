// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/results/json.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

TEST(Json, WritesReadably) {
  const Json json = Json::Object{{"name", "a \"b\"\n\x01"},
                                 {"list", Json::Array{1, 2.5, true}},
                                 {"empty", Json::Object{}},
                                 {"rows", Json::Array{Json::Object{{"x", Json()}}}}};
  EXPECT_EQ(json.write(),
            "{\n  \"name\": \"a \\\"b\\\"\\n\\u0001\",\n  \"list\": [1, 2.5, true],\n  \"empty\": {},\n  "
            "\"rows\": [\n"
            "    {\n      \"x\": null\n    }\n  ]\n}");
}

TEST(Json, ReadsWhatItWrites) {
  const Json json = Json::Object{
      {"pi", M_PI}, {"tiny", -5e-324}, {"text", "t\x02ü\\"}, {"list", Json::Array{false, Json()}}};
  const Json back = Json::parse(json.write());
  EXPECT_EQ(back.at("pi").number(), M_PI);
  EXPECT_EQ(back.at("tiny").number(), -5e-324);
  EXPECT_EQ(back.at("text").text(), "t\x02ü\\");
  EXPECT_FALSE(back.at("list").items()[0].flag());
  EXPECT_TRUE(back.at("list").items()[1].is_null());
  EXPECT_EQ(back.write(), json.write());
}

TEST(Json, WhatIsNotFiniteBecomesNull) {
  EXPECT_EQ(Json(std::nan("")).write(), "null");
  EXPECT_EQ(Json(HUGE_VAL).write(), "null");
}

TEST(Json, RefusesBrokenText) {
  for (const char* text : {"", "{", "[1,", "{\"a\" 1}", "\"open", "nul", "{} x", "[1 2]", "\"\\u00e4\""}) {
    EXPECT_THROW(Json::parse(text), InputError) << text;
  }
  EXPECT_THROW(Json::parse(std::string(1000, '[')), InputError);
  EXPECT_THROW(Json::parse("{}").at("x"), InputError);
  EXPECT_THROW(Json::parse("3").text(), InputError);
}

}  // namespace
}  // namespace hydroscope
