#include "render_core/draw/drawers/data/data_frame.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "render_core/draw/shader_texts.hpp"

namespace tedavis::draw::test_data_frame {
namespace {

TEST(DataFrame, ItsUniformsAreThoseOfTheSharedShaders) {
    std::string texts(shader_text(k_data_light_vert));
    texts += shader_text(k_air_frag);
    texts += shader_text(k_data_color_frag);
    std::set<std::string> names;
    for (const char* name : kDataUniformNames) {
        names.insert(name);
        EXPECT_NE(texts.find(" " + std::string(name) + ";"), std::string::npos) << name;
    }
    EXPECT_EQ(names.size(), std::size_t{kFirstOwnDataUniform}) << "each once";
    std::size_t declared = 0;
    for (std::size_t at = texts.find("uniform "); at != std::string::npos; at = texts.find("uniform ", at + 1)) ++declared;
    EXPECT_EQ(declared, std::size_t{kFirstOwnDataUniform} + 1) << "none is left unset; near_fade is of solids only";
}

}  // namespace
}  // namespace tedavis::draw::test_data_frame
