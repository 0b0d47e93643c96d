// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/ros/taking.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace safety_control_cloud {
namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue sensor(const std::vector<std::pair<const char*, XmlRpcValue>>& entries) {
  XmlRpcValue value;
  for (const auto& [key, entry] : entries) value[key] = entry;
  return value;
}

XmlRpcValue list_of(const XmlRpcValue& entry) {
  XmlRpcValue list;
  list.setSize(1);
  list[0] = entry;
  return list;
}

std::string problem_of(const XmlRpcValue& value) {
  Sensors sensors;
  return Taking{value}.into(sensors).value_or("");
}

TEST(Taking, ASensorHasANameATypeATopicAndWhatIsItsOwn) {
  Sensors sensors;
  const auto given = list_of(sensor({{"name", "laser"},
                                     {"type", "scan"},
                                     {"topic", "scan"},
                                     {"required", false},
                                     {"min_points", 2},
                                     {"noise", 0.03},
                                     {"inf_is_free", true},
                                     {"zero_is_inf", true}}));
  ASSERT_FALSE(Taking{given}.into(sensors));
  const SensorSettings expected{"laser",
                                InputKind::Scan,
                                "scan",
                                false,
                                {{"min_points", 2.0}, {"noise", 0.03}, {"inf_is_free", 1.0}, {"zero_is_inf", 1.0}}};
  EXPECT_EQ(sensors, Sensors{expected});
}

TEST(Taking, OfASensorWhatIsOfAnotherKindIsNamedWithItsPlace) {
  EXPECT_EQ(problem_of(XmlRpcValue("front")), "must be a list of sensors");
  EXPECT_EQ(problem_of(list_of(XmlRpcValue("front"))), "[0] must have a name, a type and a topic");
  EXPECT_EQ(problem_of(list_of(sensor({{"name", "front"}, {"topic", "scan"}}))),
            "[0] must have a name, a type and a topic");
  EXPECT_EQ(problem_of(list_of(sensor({{"type", "sonar"}}))), "[0] type must be cloud, depth or scan");
  EXPECT_EQ(problem_of(list_of(sensor({{"name", 7}}))), "[0] name must be a name");
  EXPECT_EQ(problem_of(list_of(sensor({{"required", "yes"}}))), "[0] required must be true or false");
  EXPECT_EQ(problem_of(list_of(sensor({{"inf_is_free", 1}}))), "[0] inf_is_free must be true or false");
  EXPECT_EQ(problem_of(list_of(sensor({{"min_points", true}}))), "[0] min_points must be a number");
}

TEST(Taking, ASwitchHasANameATypeATopicAndMayHaveASideAndATimeout) {
  Switches switches;
  ASSERT_FALSE(Taking{
      list_of(sensor({{"name", "edge"}, {"type", "cliff"}, {"topic", "cliff"}, {"side", "rear_left"}, {"timeout", 1}}))}
                   .into(switches));
  EXPECT_EQ(switches, (Switches{{"edge", SwitchKind::Cliff, "cliff", Edge::RearLeft, 1.0}}));
  ASSERT_FALSE(Taking{list_of(sensor({{"name", "kobuki"}, {"type", "bumper"}, {"topic", "events"}}))}.into(switches));
  EXPECT_EQ(switches, (Switches{{"kobuki", SwitchKind::Bumper, "events", std::nullopt, 0.0}}));
}

TEST(Taking, OfASwitchWhatIsOfAnotherKindIsNamedWithItsPlace) {
  Switches switches;
  const auto problem = [&](const XmlRpcValue& value) { return Taking{value}.into(switches).value_or(""); };
  EXPECT_EQ(problem(XmlRpcValue("front")), "must be a list of switches");
  EXPECT_EQ(problem(list_of(XmlRpcValue(7))), "[0] must have a name, a type and a topic");
  EXPECT_EQ(problem(list_of(sensor({{"topic", "cliff"}}))), "[0] must have a name, a type and a topic");
  EXPECT_EQ(problem(list_of(sensor({{"type", "button"}}))), "[0] type must be bumper or cliff");
  EXPECT_EQ(problem(list_of(sensor({{"side", "ahead"}}))).substr(0, 22), "[0] side must be front");
  EXPECT_EQ(problem(list_of(sensor({{"side", 0}}))).substr(0, 22), "[0] side must be front");
  EXPECT_EQ(problem(list_of(sensor({{"timeout", "1 s"}}))), "[0] timeout must be a number");
  EXPECT_EQ(problem(list_of(sensor({{"required", true}}))), "[0] has no required");
}

TEST(Taking, AFlagIsTrueOrFalse) {
  bool flag = false;
  EXPECT_FALSE(Taking{XmlRpcValue(true)}.into(flag));
  EXPECT_TRUE(flag);
  EXPECT_TRUE(Taking{XmlRpcValue(1)}.into(flag));
}

}  // namespace
}  // namespace safety_control_cloud
