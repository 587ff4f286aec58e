#include "platform/programs/program_folder.hpp"

#include <sys/stat.h>

#include <cstring>
#include <new>

#include "platform/files/file_byte_source.hpp"
#include "render_core/base/hash.hpp"

namespace tedavis::platform {
namespace {

constexpr unsigned char kMagic[8] = {'T', 'E', 'D', 'P', 'R', 'O', 'G', '1'};
constexpr std::size_t kChecksumAt = 8, kFormatAt = 12, kKeyAt = 16;

void put(std::uint64_t value, unsigned bytes, unsigned char* out) {
    for (unsigned i = 0; i < bytes; ++i) out[i] = static_cast<unsigned char>(value >> (8 * i));
}

std::uint64_t get(unsigned bytes, const unsigned char* in) {
    std::uint64_t value = 0;
    for (unsigned i = 0; i < bytes; ++i) value |= std::uint64_t{in[i]} << (8 * i);
    return value;
}

std::uint32_t checksum(const unsigned char* header, base::Span<const unsigned char> binary) {
    return base::crc32(binary.data(), binary.size(), base::crc32(header + kFormatAt, kProgramHeaderBytes - kFormatAt));
}

}  // namespace

void write_program_header(std::uint64_t key, const base::StoredProgram& program, unsigned char (&header)[kProgramHeaderBytes]) {
    std::memcpy(header, kMagic, sizeof kMagic);
    put(program.format, 4, header + kFormatAt);
    put(key, 8, header + kKeyAt);
    put(checksum(header, program.binary), 4, header + kChecksumAt);
}

base::FixedString<31> program_file_name(std::uint64_t key) {
    char digits[17];
    for (int i = 0; i < 16; ++i) digits[i] = "0123456789abcdef"[(key >> (60 - 4 * i)) & 15];
    digits[16] = 0;
    base::FixedString<31> name(digits);
    name.append(".program");
    return name;
}

bool ProgramFolder::find(std::uint64_t key, base::StoredProgram& program) {
    if (!bytes_) return false;
    base::FixedString<1087> path(path_.view());
    path.append("/");
    path.append(program_file_name(key).view());
    auto file = open_file(path.c_str());
    if (!file.ok() || file.value().size() <= kProgramHeaderBytes || file.value().size() > kMaxProgramBytes) return false;
    const auto size = static_cast<std::size_t>(file.value().size());
    if (!file.value().read(0, bytes_.get(), size)) return false;
    const unsigned char* const header = bytes_.get();
    const base::Span<const unsigned char> binary(header + kProgramHeaderBytes, size - kProgramHeaderBytes);
    const bool is_whole = std::memcmp(header, kMagic, sizeof kMagic) == 0 && get(8, header + kKeyAt) == key &&
                          get(4, header + kChecksumAt) == checksum(header, binary);
    program = {static_cast<std::uint32_t>(get(4, header + kFormatAt)), binary};
    return is_whole;
}

base::Result<ProgramFolder, base::Error> open_program_folder(std::string_view path) {
    ProgramFolder folder;
    folder.path_ = base::FixedString<1023>(path);
    struct stat status {};
    if (folder.path_.cut() || ::stat(folder.path_.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
        return base::fail(base::make_error(
            folder.path_.view(), ": no folder of programs; make it with 'tedavis-display --write-shaders' or 'tedavis shaders'"));
    folder.bytes_.reset(new (std::nothrow) unsigned char[kMaxProgramBytes]);
    if (!folder.bytes_) return base::fail(base::make_error(folder.path_.view(), ": no memory to read programs with"));
    return folder;
}

}  // namespace tedavis::platform
