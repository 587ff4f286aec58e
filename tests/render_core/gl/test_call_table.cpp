#include "render_core/gl/call_table.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace tedavis::gl::test_call_table {
namespace {

/// What OpenGL SC 2.0.1 took out of OpenGL ES 2.0, from its specification's list of differences.
const std::set<std::string> kNotInSc2 = {"AttachShader",        "BindAttribLocation",
                                         "CompileShader",       "CompressedTexImage2D",
                                         "CopyTexImage2D",      "CopyTexSubImage2D",
                                         "CreateShader",        "DeleteBuffers",
                                         "DeleteFramebuffers",  "DeleteProgram",
                                         "DeleteRenderbuffers", "DeleteShader",
                                         "DeleteTextures",      "DetachShader",
                                         "DrawElements",        "GetActiveAttrib",
                                         "GetActiveUniform",    "GetAttachedShaders",
                                         "GetProgramInfoLog",   "GetShaderiv",
                                         "GetShaderInfoLog",    "GetShaderPrecisionFormat",
                                         "GetShaderSource",     "GetUniformfv",
                                         "GetUniformiv",        "IsBuffer",
                                         "IsFramebuffer",       "IsProgram",
                                         "IsRenderbuffer",      "IsShader",
                                         "IsTexture",           "LinkProgram",
                                         "ReadPixels",          "ReleaseShaderCompiler",
                                         "ShaderBinary",        "ShaderSource",
                                         "TexImage2D",          "ValidateProgram"};
/// What it added.
const std::set<std::string> kAddedBySc2 = {"ProgramBinary", "TexStorage2D",  "DrawRangeElements", "GetGraphicsResetStatus",
                                           "GetnUniformfv", "GetnUniformiv", "ReadnPixels"};

effects::GlRules rules_of(effects::CallClass calls) {
    effects::GlRules rules;
    rules.calls = calls;
    return rules;
}

bool has(effects::CallClass calls, const char* name) { return device_has(rules_of(calls), find_call(name)); }

TEST(CallTable, EveryNameIsFoundOnceAndInOrder) {
    for (std::size_t i = 0; i < kCallCount; ++i) {
        EXPECT_EQ(find_call(kCalls[i].name), static_cast<CallId>(i)) << kCalls[i].name;
        if (i == 0) continue;
        EXPECT_LT(std::string(kCalls[i - 1].name), std::string(kCalls[i].name));
    }
    EXPECT_EQ(find_call("Clea"), CallId::count);
    EXPECT_EQ(find_call("glClear"), CallId::count);
    EXPECT_EQ(find_call(""), CallId::count);
}

TEST(CallTable, Es2CallsOfTheTableAreThoseOfSc2LessTheRemovedOnes) {
    for (const CallDescription& call : kCalls) {
        const bool in_es2 = device_has(rules_of(effects::CallClass::es2), find_call(call.name));
        const bool in_sc2 = device_has(rules_of(effects::CallClass::sc2), find_call(call.name));
        const bool expected = in_es2 ? kNotInSc2.count(call.name) == 0 : in_sc2 && kAddedBySc2.count(call.name) == 1;
        EXPECT_EQ(in_sc2, expected) << call.name;
    }
}

TEST(CallTable, Es3HoldsAllOfEs2) {
    for (const CallDescription& call : kCalls)
        EXPECT_LE(has(effects::CallClass::es2, call.name), has(effects::CallClass::es3, call.name)) << call.name;
    EXPECT_TRUE(has(effects::CallClass::es3, "TexStorage2D"));
    EXPECT_FALSE(has(effects::CallClass::es2, "TexStorage2D"));
    EXPECT_FALSE(has(effects::CallClass::es3, "ReadnPixels"));
    for (const char* name : {"DrawElementsInstanced", "VertexAttribDivisor"}) {
        EXPECT_TRUE(has(effects::CallClass::es3, name)) << name;
        EXPECT_FALSE(has(effects::CallClass::es2, name)) << name;
        EXPECT_FALSE(has(effects::CallClass::sc2, name)) << name;
    }
}

TEST(CallTable, DeviceFileAddsAndRemovesSingleCalls) {
    effects::GlRules rules = rules_of(effects::CallClass::es2);
    ASSERT_TRUE(rules.also.try_push_back("DrawRangeElements"));
    ASSERT_TRUE(rules.never.try_push_back("GenerateMipmap"));
    EXPECT_TRUE(device_has(rules, CallId::DrawRangeElements));
    EXPECT_FALSE(device_has(rules, CallId::GenerateMipmap));
    ASSERT_TRUE(rules.never.try_push_back("DrawRangeElements"));
    EXPECT_FALSE(device_has(rules, CallId::DrawRangeElements)) << "never wins";
}

TEST(CallTable, StorageAndCompilationAreStartUpCalls) {
    for (const char* name : {"BufferData", "TexImage2D", "TexStorage2D", "RenderbufferStorage", "CompileShader", "LinkProgram",
                             "GenBuffers", "GenTextures", "CreateProgram", "ProgramBinary", "GetUniformLocation"})
        EXPECT_EQ(describe(find_call(name)).stage, CallStage::start) << name;
    for (const char* name : {"Clear", "DrawElements", "BufferSubData", "TexSubImage2D", "UniformMatrix4fv", "ReadPixels"})
        EXPECT_EQ(describe(find_call(name)).stage, CallStage::both) << name;
    for (const CallDescription& call : kCalls)
        EXPECT_EQ(call.stage == CallStage::teardown, std::string(call.name).rfind("Delete", 0) == 0) << call.name;
}

}  // namespace
}  // namespace tedavis::gl::test_call_table
