#include "render_core/gl/shader_prefix.hpp"

#include <gtest/gtest.h>

namespace tedavis::gl::test_shader_prefix {
namespace {

using effects::Lane;

TEST(ShaderPrefix, BeginsWithTheVersionOfItsLane) {
    for (ShaderStage stage : {ShaderStage::vertex, ShaderStage::fragment}) {
        EXPECT_EQ(shader_prefix(Lane::es2, stage).substr(0, 13), "#version 100\n");
        EXPECT_EQ(shader_prefix(Lane::es3, stage).substr(0, 16), "#version 300 es\n");
    }
}

TEST(ShaderPrefix, EndsSoThatLinesCountFromOne) {
    for (Lane lane : {Lane::es2, Lane::es3})
        for (ShaderStage stage : {ShaderStage::vertex, ShaderStage::fragment}) {
            const std::string_view prefix = shader_prefix(lane, stage);
            EXPECT_EQ(prefix.substr(prefix.size() - 8), "#line 1\n");
        }
}

}  // namespace
}  // namespace tedavis::gl::test_shader_prefix
