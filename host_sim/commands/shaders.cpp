#include "host_sim/commands/shaders.hpp"

#include <nlohmann/json.hpp>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/own_ground.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/temporary_folder.hpp"
#include "host_sim/user_error.hpp"
#include "platform/programs/program_folder.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;
using Made = MadePrograms::Made;

std::string file_of(std::uint64_t key) { return std::string(platform::program_file_name(key).view()); }

void write_program(const std::string& folder, std::uint64_t key, const Made& made) {
    unsigned char header[platform::kProgramHeaderBytes];
    platform::write_program_header(key, {made.format, made.binary}, header);
    std::string bytes(reinterpret_cast<const char*>(header), sizeof header);
    bytes.append(made.binary.begin(), made.binary.end());
    write_file_atomically(folder + "/" + file_of(key), bytes);
}

Json list_of(const ShadersOptions& options, const MadePrograms& programs) {
    Json list{{"device", options.picture.device}, {"design", options.picture.design}, {"programs", Json::array()}};
    for (const auto& [key, made] : programs.all())
        list["programs"].push_back({{"name", made.name}, {"file", file_of(key)}, {"bytes", made.binary.size()}});
    return list;
}

}  // namespace

int run_shaders(const ShadersOptions& options, Console& console) {
    if (DisplaySession::has_compiler(options.picture))
        throw UserError("--device " + options.picture.device + ": it has a compiler and needs no programs; name one without");
    const TemporaryFolder temporary;
    PictureOptions picture = options.picture;
    use_own_ground(picture, temporary.path(), console);
    const MadePrograms programs = DisplaySession::make_programs(picture);
    require_uninterrupted(options.output);
    NewFolder folder(options.output);
    for (const auto& [key, made] : programs.all()) write_program(options.output, key, made);
    const Json list = list_of(options, programs);
    write_file_atomically(options.output + "/programs.json", json_text(list, 2) + "\n");
    folder.keep();
    console.result(options.output + ": " + std::to_string(programs.all().size()) + " programs for " + picture.device +
                       ", readable by this machine's driver alone",
                   json_text(list));
    return 0;
}

}  // namespace tedavis::host_sim
