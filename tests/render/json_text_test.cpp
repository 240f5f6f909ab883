// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/json_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace hydroscope {
namespace {

TEST(JsonText, WritesKeysInOrderNumbersExactlyAndNoNumbersAsNull) {
  JsonText inner, json;
  inner.add("stick", 3);
  json.add("label", std::string("t = \"1\"\n"));
  json.add("third", 1.0 / 3.0);
  json.add("nothing", std::numeric_limits<double>::quiet_NaN());
  json.add("list", std::vector<double>{1.0, -0.5});
  json.add("counts", inner);
  json.add("yes", true);
  EXPECT_EQ(
      json.text(),
      "{\n  \"label\": \"t = \\\"1\\\"\\u000a\",\n  \"third\": 0.3333333333333333,\n  \"nothing\": null,\n"
      "  \"list\": [1, -0.5],\n  \"counts\": {\n    \"stick\": 3\n  },\n  \"yes\": true\n}\n");
}

TEST(JsonText, AnEmptyObjectIsStillOne) {
  JsonText json;
  json.add("range", JsonText{});
  EXPECT_EQ(json.text(), "{\n  \"range\": {}\n}\n");
}

}  // namespace
}  // namespace hydroscope
