#include "host_sim/scene_builder/model_source.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr unsigned kPreparation = aiProcess_Triangulate | aiProcess_PreTransformVertices | aiProcess_GenNormals |
                                  aiProcess_JoinIdenticalVertices | aiProcess_SortByPType;

/// IEC 61966-2-1, from the linear light of glTF's factors.
std::uint8_t encoded(float linear) {
    const double light = std::clamp(static_cast<double>(linear), 0.0, 1.0);
    const double code = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * code));
}

std::int8_t normal_code(float component) {
    return static_cast<std::int8_t>(std::lround(127 * std::clamp(component, -1.0f, 1.0f)));
}

aiColor4D color_of(const aiMaterial& material) {
    aiColor4D color(0.8f, 0.8f, 0.8f, 1);
    if (material.Get(AI_MATKEY_BASE_COLOR, color) != AI_SUCCESS) (void)material.Get(AI_MATKEY_COLOR_DIFFUSE, color);
    return color;
}

bool has_ending(const std::string& path, const std::string& ending) {
    return path.size() >= ending.size() && path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

class ModelReader {
public:
    explicit ModelReader(const std::string& path) : path_(path) {}

    ModelDraft read() {
        if (!has_ending(path_, ".gltf") && !has_ending(path_, ".glb"))
            throw UserError(path_ + ": is no glTF file (.gltf, .glb); export the model as glTF 2.0");
        Assimp::Importer importer;
        const aiScene* const scene = importer.ReadFile(path_, kPreparation);
        if (scene == nullptr)
            throw UserError(path_ + ": cannot be read as a 3D model (" + one_line(importer.GetErrorString()) +
                            "); give a glTF 2.0 file");
        for (unsigned n = 0; n < scene->mNumMeshes; ++n) {
            const aiMesh& mesh = *scene->mMeshes[n];
            if ((mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) != 0)
                add(mesh, color_of(*scene->mMaterials[mesh.mMaterialIndex]));
        }
        if (model_.triangles.empty()) throw UserError(path_ + ": has no triangles; export the model with its surfaces");
        return std::move(model_);
    }

private:
    void add(const aiMesh& mesh, const aiColor4D& material) {
        const std::size_t first = model_.vertices.size();
        if (first + mesh.mNumVertices > kMaxModelVertices || model_.triangles.size() + mesh.mNumFaces > kMaxModelTriangles)
            throw UserError(path_ + ": has more than " + std::to_string(kMaxModelVertices) + " vertices or " +
                            std::to_string(kMaxModelTriangles) + " triangles; simplify the model");
        for (unsigned n = 0; n < mesh.mNumVertices; ++n) model_.vertices.push_back(vertex(mesh, n, material));
        for (unsigned n = 0; n < mesh.mNumFaces; ++n) {
            const aiFace& face = mesh.mFaces[n];
            const auto corner = [&](unsigned k) { return static_cast<std::uint16_t>(first + face.mIndices[k]); };
            if (face.mNumIndices == 3) model_.triangles.push_back({corner(0), corner(1), corner(2)});
        }
    }

    [[nodiscard]] scene::ModelVertex vertex(const aiMesh& mesh, unsigned n, const aiColor4D& material) const {
        const aiVector3D& at = mesh.mVertices[n];
        if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z))
            throw UserError(path_ + ": a vertex is no number; export the model anew");
        scene::ModelVertex vertex{{-at.x, at.z, at.y}, {0, 0, 0, 0}, {}};
        if (mesh.HasNormals()) {
            const aiVector3D& normal = mesh.mNormals[n];
            vertex.normal[0] = normal_code(-normal.x);
            vertex.normal[1] = normal_code(normal.z);
            vertex.normal[2] = normal_code(normal.y);
        }
        aiColor4D color = material;
        if (mesh.HasVertexColors(0)) color = color * mesh.mColors[0][n];
        vertex.color[0] = encoded(color.r);
        vertex.color[1] = encoded(color.g);
        vertex.color[2] = encoded(color.b);
        vertex.color[3] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(color.a, 0.0f, 1.0f)));
        return vertex;
    }

    const std::string& path_;
    ModelDraft model_;
};

}  // namespace

ModelDraft read_model(const std::string& path) { return ModelReader(path).read(); }

}  // namespace tedavis::host_sim
