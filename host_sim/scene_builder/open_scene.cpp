#include "host_sim/scene_builder/open_scene.hpp"

#include "host_sim/user_error.hpp"
#include "platform/files/file_byte_source.hpp"

namespace tedavis::host_sim {
namespace {

/// A forged header is refused before its file is believed to be that large.
constexpr std::uint64_t kLargest = std::uint64_t{1} << 34;

}  // namespace

OpenScene::OpenScene(const std::string& path) {
    auto file = platform::open_file(path.c_str());
    if (!file.ok()) throw UserError(std::string(file.error().message.view()));
    if (file.value().size() > kLargest) throw UserError(path + ": larger than any scene database; name another file");
    const std::size_t bytes = static_cast<std::size_t>(scene::Scene::bytes_needed(file.value().size()));
    memory_.reset(new unsigned char[bytes]);
    base::Arena arena(memory_.get(), bytes);
    auto loaded = scene::Scene::load(file.value(), arena);
    if (!loaded.ok()) throw UserError(path + ": " + std::string(describe(loaded.error()).view()));
    scene_ = loaded.value();
}

}  // namespace tedavis::host_sim
