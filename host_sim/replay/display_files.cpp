#include "host_sim/replay/display_files.hpp"

#include <vector>

#include "host_sim/input_file.hpp"
#include "host_sim/replay/byte_stream.hpp"
#include "host_sim/replay/index_key.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/replay/open_log.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

class DisplayFilesReader {
public:
    void add(const std::string& path) { add(path, read_file(path)); }
    void add(const std::string& path, const std::string& text) {
        content_.put_text(text);
        stamps_.put_text(path);
        stamps_.put(times_identity(path));
    }
    /// Too large to be read whole, and told by its times.
    void add_scene(const std::string& path) {
        content_.put(file_identity(path, *open_log(path)).hash);
        stamps_.put(times_identity(path));
    }
    /// Made for each run anew, so that its times tell nothing.
    void add_made_scene(const std::string& path) {
        content_.put(text_identity(read_file(path)));
        stamps_.put(times_identity(path));
    }
    [[nodiscard]] DisplayFiles take() { return {content_.take(), stamps_.take()}; }

private:
    ByteWriter content_, stamps_;
};

DisplayFiles read_display_files(const PictureOptions& picture) {
    DisplayFilesReader reader;
    std::vector<ReadFile> designs;
    static_cast<void>(load_designs(picture, &designs));
    for (const ReadFile& file : designs) reader.add(file.path, file.text);
    reader.add(resolve_config(picture.device, "devices"));
    if (!picture.aircraft.empty()) reader.add(resolve_config(picture.aircraft, "aircraft"));
    if (!picture.palette.empty()) reader.add(resolve_config(picture.palette, "palettes/symbology"));
    if (!picture.ghosts.scene.empty())
        reader.add_made_scene(picture.ghosts.scene);
    else if (!picture.scene.empty())
        reader.add_scene(picture.scene);
    return reader.take();
}

}  // namespace

std::optional<DisplayFiles> display_files(const PictureOptions& picture) {
    try {
        return read_display_files(picture);
    } catch (const UserError&) {
        return std::nullopt;
    }
}

bool equal(const std::optional<DisplayFiles>& before, const std::optional<DisplayFiles>& after) {
    return before && after && before->content == after->content && before->stamps == after->stamps;
}

}  // namespace tedavis::host_sim
