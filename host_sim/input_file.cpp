#include "host_sim/input_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

struct GzCloser {
    void operator()(gzFile_s* file) const { gzclose_r(file); }
};

}  // namespace

void require_regular_file(const std::string& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) throw UserError(path + ": no such file; check the path");
    if (std::filesystem::is_directory(status)) throw UserError(path + ": is a folder; name a file");
    if (std::filesystem::is_character_file(status) || std::filesystem::is_block_file(status))
        throw UserError(path + ": is a device, which may have no end; name a file");
}

std::string read_file(const std::string& path) {
    require_regular_file(path);
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw UserError(path + ": cannot be opened (" + std::strerror(errno) + "); check its permissions");
    std::ostringstream text;
    if (stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
    if (stream.bad() || text.bad()) throw UserError(path + ": cannot be read to its end; check the disk");
    return std::move(text).str();
}

std::vector<std::uint8_t> read_bytes(const std::string& path) {
    const std::string text = read_file(path);
    return {text.begin(), text.end()};
}

std::string read_file_unpacked(const std::string& path, std::size_t max_bytes) {
    require_regular_file(path);
    const std::unique_ptr<gzFile_s, GzCloser> file(gzopen(path.c_str(), "rb"));
    if (file == nullptr) throw UserError(path + ": cannot be opened (" + std::strerror(errno) + "); check its permissions");
    std::string text;
    std::string piece(1 << 18, '\0');
    for (;;) {
        const int count = gzread(file.get(), piece.data(), static_cast<unsigned>(piece.size()));
        int code = Z_OK;
        gzerror(file.get(), &code);
        if (count < 0 || code != Z_OK) {
            throw UserError(path + ": the compressed data break off or are damaged after " + std::to_string(text.size()) +
                            " unpacked bytes; fetch the file again");
        }
        if (count == 0) return text;
        if (text.size() + static_cast<std::size_t>(count) > max_bytes) {
            throw UserError(path + ": unpacks to more than " + std::to_string(max_bytes) + " bytes; split the recording");
        }
        text.append(piece, 0, static_cast<std::size_t>(count));
    }
}

void require_other_file(const std::string& output, const std::vector<std::string>& inputs) {
    for (const std::string& input : inputs) {
        std::error_code not_there;
        if (std::filesystem::equivalent(input, output, not_there))
            throw UserError(output + ": is also an input of this command; name another output");
    }
}

void require_replaceable(const std::string& output, const BeginsAsOwn& is_own, const std::string& kind) {
    constexpr std::size_t kLooked = 64;
    std::error_code not_there;
    if (!std::filesystem::is_regular_file(output, not_there)) return;
    std::string found(kLooked, '\0');
    std::ifstream file(output, std::ios::binary);
    const bool is_empty = file.is_open() && file.peek() == std::ifstream::traits_type::eof();
    file.read(found.data(), static_cast<std::streamsize>(found.size()));
    found.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    if (!is_empty && !is_own(found))
        throw UserError(output + ": is there already and is no " + kind + "; name another output, or remove this file first");
}

void require_replaceable(const std::string& output, std::string_view beginning, const std::string& kind) {
    require_replaceable(
        output, [&](std::string_view found) { return found.substr(0, beginning.size()) == beginning; }, kind);
}

void require_replaceable_log(const std::string& output) {
    const auto is_candump = [](std::string_view found) {
        const std::size_t seconds = found.find_first_not_of("0123456789", 1),
                          part = found.find_first_not_of("0123456789", seconds + 1);
        return found.substr(0, 1) == "(" && seconds > 1 && seconds < found.size() && found[seconds] == '.' &&
               part > seconds + 1 && part < found.size() && found.substr(part, 2) == ") ";
    };
    require_replaceable(output, is_candump, "candump log");
}

}  // namespace tedavis::host_sim
