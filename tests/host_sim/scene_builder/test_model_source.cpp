#include "host_sim/scene_builder/model_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/host_sim/scene_builder/model_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_model_source {
namespace {

using test_support::expect_user_error;
using test_support::TemporaryFolder;
using test_support::tetrahedron;

TEST(ModelSource, AxesBecomeRightAheadAndUp) {
    const TemporaryFolder folder;
    folder.write("hut.gltf", tetrahedron());
    const ModelDraft model = read_model(folder.file("hut.gltf"));
    EXPECT_EQ(model.triangles.size(), 4u);
    double six_times = 0;
    float highest = 0, farthest_ahead = 0, farthest_left = 0;
    for (const auto& triangle : model.triangles) {
        const float *a = model.vertices[triangle[0]].place_m, *b = model.vertices[triangle[1]].place_m,
                    *c = model.vertices[triangle[2]].place_m;
        six_times +=
            static_cast<double>(a[0] * (b[1] * (c[2] - 10) - (b[2] - 10) * c[1]) -
                                a[1] * (b[0] * (c[2] - 10) - (b[2] - 10) * c[0]) + (a[2] - 10) * (b[0] * c[1] - b[1] * c[0]));
    }
    EXPECT_NEAR(six_times, 24, 1e-4) << "as large, and still outwards";
    for (const scene::ModelVertex& vertex : model.vertices) {
        highest = std::max(highest, vertex.place_m[2]);
        farthest_ahead = std::max(farthest_ahead, vertex.place_m[1]);
        farthest_left = std::min(farthest_left, vertex.place_m[0]);
        EXPECT_EQ(vertex.color[0], 188) << "half of the light, in sRGB";
        EXPECT_EQ(vertex.color[1], 0);
        EXPECT_EQ(vertex.color[3], 255);
        const int length =
            vertex.normal[0] * vertex.normal[0] + vertex.normal[1] * vertex.normal[1] + vertex.normal[2] * vertex.normal[2];
        EXPECT_NEAR(length, 127 * 127, 300);
    }
    EXPECT_FLOAT_EQ(highest, 13);
    EXPECT_FLOAT_EQ(farthest_ahead, 4);
    EXPECT_FLOAT_EQ(farthest_left, -2);
}

TEST(ModelSource, RefusesWhatIsNoModelOrTooMuch) {
    const TemporaryFolder folder;
    folder.write("text.gltf", "no model");
    folder.write("empty.gltf", R"({"asset": {"version": "2.0"}})");
    folder.write("large.gltf", tetrahedron(1100));
    const auto expect = [&](const char* file, const std::string& words) {
        expect_user_error([&] { (void)read_model(folder.file(file)); }, words);
    };
    expect("hut.obj", "hut.obj: is no glTF file");
    expect("text.gltf", "text.gltf: cannot be read as a 3D model");
    expect("none.gltf", "none.gltf: cannot be read as a 3D model");
    expect("empty.gltf", "empty.gltf: ");
    expect("large.gltf", "has more than 4096 vertices or 4096 triangles; simplify the model");
}

}  // namespace
}  // namespace tedavis::host_sim::test_model_source
