/// OGRE's terrain component over the common raster: its triangles and its level of detail by the pixel error of the option
/// (`1`), in one colour. The conversation is that of peer_loop.hpp. Runs with a display (GLX).
///
/// Frame of OGRE: x east, y up, z south, the raster's middle at the origin.
#include <dlfcn.h>

#include <Ogre.h>
#include <OgreTerrain.h>

#include "tests/bench/peers/peer_loop.hpp"

namespace {

using namespace tedavis;

constexpr const char* kRenderSystem = "/OGRE/RenderSystem_GL3Plus";
constexpr const char* kDepthScheme = "depth";

// The morph of OGRE's own shaders (TerrainTransforms.glsl): `uv1` holds the vertex's difference and the level where it ends.
constexpr const char* kVertexShader =
    "#version 150\n"
    "in vec4 vertex;\nin vec2 uv1;\nuniform mat4 world, view_projection;\nuniform vec4 lod_morph;\n"
    "void main() {\n"
    "    vec4 place = world * vertex;\n"
    "    place.y += uv1.x * -min(0.0, sign(uv1.y - lod_morph.y)) * lod_morph.x;\n"
    "    gl_Position = view_projection * place;\n"
    "}\n";
const std::string kPlainShader = "#version 150\nout vec4 color;\nvoid main() { color = vec4(0.4, 0.5, 0.3, 1.0); }\n";
const std::string kDepthShader = std::string("#version 150\nout vec4 color;\nvoid main() {\n") + peers::kDepthColorCode +
                                 "color = vec4(depth_color, 1.0);\n}\n";

/// One colour, and by the scheme `depth` the depth.
class PlainProfile : public Ogre::TerrainMaterialGenerator::Profile {
public:
    explicit PlainProfile(Ogre::TerrainMaterialGenerator* parent) : Profile(parent, "plain", "") {
        make_program("peer vertex", Ogre::GPT_VERTEX_PROGRAM, kVertexShader);
        make_program("peer plain", Ogre::GPT_FRAGMENT_PROGRAM, kPlainShader);
        make_program("peer depth", Ogre::GPT_FRAGMENT_PROGRAM, kDepthShader);
    }
    bool isVertexCompressionSupported() const override { return false; }
    Ogre::MaterialPtr generate(const Ogre::Terrain* terrain) override {
        auto material = Ogre::MaterialManager::getSingleton().getByName(terrain->getMaterialName());
        if (material) return material;
        material = Ogre::MaterialManager::getSingleton().create(terrain->getMaterialName(), kGroup);
        material->removeAllTechniques();
        add_technique(material, Ogre::MaterialManager::DEFAULT_SCHEME_NAME, "peer plain");
        add_technique(material, kDepthScheme, "peer depth");
        return material;
    }
    Ogre::MaterialPtr generateForCompositeMap(const Ogre::Terrain* /*terrain*/) override { return {}; }
    void setLightmapEnabled(bool /*enabled*/) override {}
    Ogre::uint8 getMaxLayers(const Ogre::Terrain* /*terrain*/) const override { return 1; }
    void updateCompositeMap(const Ogre::Terrain* /*terrain*/, const Ogre::Rect& /*rect*/) override {}
    void updateParams(const Ogre::MaterialPtr& /*material*/, const Ogre::Terrain* /*terrain*/) override {}
    void updateParamsForCompositeMap(const Ogre::MaterialPtr& /*material*/, const Ogre::Terrain* /*terrain*/) override {}
    void requestOptions(Ogre::Terrain* terrain) override {
        terrain->_setMorphRequired(true);
        terrain->_setNormalMapRequired(false);
        terrain->_setLightMapRequired(false);
        terrain->_setCompositeMapRequired(false);
    }

private:
    static constexpr const char* kGroup = "General";

    static void make_program(const char* name, Ogre::GpuProgramType kind, const std::string& text) {
        auto program = Ogre::HighLevelGpuProgramManager::getSingleton().createProgram(name, kGroup, "glsl", kind);
        program->setSource(text);
        program->load();
        if (program->hasCompileError()) throw std::runtime_error(std::string(name) + " does not compile");
    }
    static void add_technique(const Ogre::MaterialPtr& material, const std::string& scheme, const char* fragment) {
        Ogre::Technique* technique = material->createTechnique();
        technique->setSchemeName(scheme);
        Ogre::Pass* pass = technique->createPass();
        pass->setVertexProgram("peer vertex");
        pass->setFragmentProgram(fragment);
        const auto parameters = pass->getVertexProgramParameters();
        parameters->setNamedAutoConstant("world", Ogre::GpuProgramParameters::ACT_WORLD_MATRIX);
        parameters->setNamedAutoConstant("view_projection", Ogre::GpuProgramParameters::ACT_VIEWPROJ_MATRIX);
        parameters->setNamedAutoConstant("lod_morph", Ogre::GpuProgramParameters::ACT_CUSTOM,
                                         Ogre::Terrain::LOD_MORPH_CUSTOM_PARAM);
    }
};

class PlainGenerator : public Ogre::TerrainMaterialGenerator {
public:
    PlainGenerator() {
        mProfiles.push_back(OGRE_NEW PlainProfile(this));
        setActiveProfile("plain");
    }
};

class OgrePeer {
public:
    explicit OgrePeer(const peers::PeerArguments& given)
        : given_(given), root_("", "", given.folder + "/ogre-" + given.option + ".log") {
        start_window();
        start_camera();
        build_ms_ = peers::spent_ms([&] { build_terrain(); });
        finish_ = reinterpret_cast<void (*)()>(dlsym(dlopen("libGL.so.1", RTLD_NOW), "glFinish"));
        if (finish_ == nullptr) throw std::runtime_error("libGL.so.1 has no glFinish");
    }
    [[nodiscard]] std::string ready() const {
        return "\"version\": \"OGRE " OGRE_PEER_VERSION "\", \"build_ms\": " + std::to_string(build_ms_);
    }
    std::string answer(const peers::Pose& pose) {
        place_camera(pose);
        draw();
        const double ms = peers::spent_ms([&] { draw(); });
        const std::size_t triangles = target_->getStatistics().triangleCount;
        write_depths();
        return "\"ms\": [" + std::to_string(ms) + "], \"triangles\": " + std::to_string(triangles);
    }

private:
    void start_window() {
        root_.loadPlugin(std::string(OGRE_PEER_LIBRARIES) + kRenderSystem);
        root_.setRenderSystem(root_.getAvailableRenderers().at(0));
        root_.initialise(false);
        const Ogre::NameValuePairList hidden = {{"hidden", "true"}, {"FSAA", "0"}, {"vsync", "false"}};
        root_.createRenderWindow("peer", 16, 16, false, &hidden);
        scene_ = root_.createSceneManager();
    }
    void start_camera() {
        texture_ =
            Ogre::TextureManager::getSingleton().createManual("picture", "General", Ogre::TEX_TYPE_2D, given_.size.width,
                                                              given_.size.height, 0, Ogre::PF_BYTE_RGBA, Ogre::TU_RENDERTARGET);
        target_ = texture_->getBuffer()->getRenderTarget();
        camera_ = scene_->createCamera("eye");
        node_ = scene_->getRootSceneNode()->createChildSceneNode();
        node_->attachObject(camera_);
        camera_->setFOVy(Ogre::Degree(peers::kVerticalField_deg));
        camera_->setAspectRatio(static_cast<float>(given_.size.width) / static_cast<float>(given_.size.height));
        camera_->setNearClipDistance(peers::kNear_m);
        camera_->setFarClipDistance(peers::kFar_m);
        viewport_ = target_->addViewport(camera_);
        viewport_->setOverlaysEnabled(false);
    }
    void build_terrain() {
        options_ = OGRE_NEW Ogre::TerrainGlobalOptions();
        options_->setMaxPixelError(std::stof(given_.option));
        options_->setDefaultMaterialGenerator(Ogre::TerrainMaterialGeneratorPtr(OGRE_NEW PlainGenerator()));
        const std::vector<std::int16_t> posts = peers::read_ground(given_.folder);
        std::vector<float> heights(posts.size());
        for (std::size_t row = 0; row < peers::kSide; ++row)
            for (std::size_t column = 0; column < peers::kSide; ++column)
                heights[(peers::kSide - 1 - row) * peers::kSide + column] = posts[row * peers::kSide + column];
        Ogre::Terrain::ImportData import;
        import.terrainSize = peers::kSide;
        import.worldSize = peers::kExtent_m;
        import.inputFloat = heights.data();
        import.deleteInputData = false;
        import.minBatchSize = 33;
        import.maxBatchSize = 65;
        terrain_ = OGRE_NEW Ogre::Terrain(scene_);
        if (!terrain_->prepare(import)) throw std::runtime_error("OGRE cannot prepare the terrain");
        terrain_->load();
        while (terrain_->isDerivedDataUpdateInProgress()) root_.getWorkQueue()->processResponses();
    }
    static Ogre::Vector3 vector_of(const glm::dvec3& east_north_up) {
        return {static_cast<float>(east_north_up.x), static_cast<float>(east_north_up.z), static_cast<float>(-east_north_up.y)};
    }
    void place_camera(const peers::Pose& pose) {
        const peers::Axes axes = peers::axes_of(pose);
        const double middle = 0.5 * peers::kExtent_m;
        node_->setPosition(vector_of({pose.x_m - middle, pose.y_m - middle, pose.z_m}));
        node_->setOrientation(Ogre::Quaternion(vector_of(axes.right), vector_of(-axes.down), vector_of(-axes.forward)));
    }
    void draw() {
        root_.renderOneFrame();
        finish_();
    }
    void write_depths() {
        viewport_->setMaterialScheme(kDepthScheme);
        draw();
        viewport_->setMaterialScheme(Ogre::MaterialManager::DEFAULT_SCHEME_NAME);
        std::vector<std::uint8_t> colors(4 * given_.size.pixels());
        target_->copyContentsToMemory(
            Ogre::Box(0, 0, given_.size.width, given_.size.height),
            Ogre::PixelBox(given_.size.width, given_.size.height, 1, Ogre::PF_BYTE_RGBA, colors.data()));
        std::vector<float> depth(given_.size.pixels());
        for (std::size_t n = 0; n < depth.size(); ++n)
            depth[n] = peers::depth_of_color(colors[4 * n], colors[4 * n + 1], colors[4 * n + 2]);
        peers::write_picture(given_.folder + "/ogre-" + given_.option + ".depth", depth);
    }

    peers::PeerArguments given_;
    Ogre::Root root_;
    Ogre::SceneManager* scene_ = nullptr;
    Ogre::TexturePtr texture_;
    Ogre::RenderTarget* target_ = nullptr;
    Ogre::Camera* camera_ = nullptr;
    Ogre::SceneNode* node_ = nullptr;
    Ogre::Viewport* viewport_ = nullptr;
    Ogre::TerrainGlobalOptions* options_ = nullptr;
    Ogre::Terrain* terrain_ = nullptr;
    void (*finish_)() = nullptr;
    double build_ms_ = 0;
};

}  // namespace

int main(int count, char** given) {
    return peers::run_peer("peer_ogre", [&] {
        auto* peer = new OgrePeer(peers::PeerArguments::of(count, given));
        peers::answer_poses(peer->ready(), [&](const peers::Pose& pose) { return peer->answer(pose); });
        std::_Exit(0);  // the driver that tests/bench/peers/run starts has no use for what OGRE would take apart
    });
}
