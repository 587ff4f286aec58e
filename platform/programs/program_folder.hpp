/// A folder of linked programs, a file each, as `tedavis shaders` writes it for a device without a compiler.
///
/// File    "<16 hex digits of the key>.program": magic "TEDPROG1", CRC-32 of all after it, format, key (little-endian u32, u32,
///         u64), then the driver's binary up to the file's end.
/// Memory  one binary, when opened. Thread  one.
#pragma once

#include <memory>
#include <string_view>

#include "render_core/base/error.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/ports/program_store.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

/// No driver's binary of one of our programs comes near it.
inline constexpr std::size_t kMaxProgramBytes = std::size_t{4} << 20;
inline constexpr std::size_t kProgramHeaderBytes = 24;

/// What stands before the binary in its file.
void write_program_header(std::uint64_t key, const base::StoredProgram& program, unsigned char (&header)[kProgramHeaderBytes]);
[[nodiscard]] base::FixedString<31> program_file_name(std::uint64_t key);

class ProgramFolder final : public base::ProgramStore {
public:
    ProgramFolder() = default;

    /// A file that is damaged or cut is as good as none.
    [[nodiscard]] bool find(std::uint64_t key, base::StoredProgram& program) override;
    /// Nothing is written here: what makes programs runs on the desk.
    [[nodiscard]] base::Span<unsigned char> room(std::size_t) override { return {}; }
    [[nodiscard]] bool keep(std::uint64_t, std::string_view, const base::StoredProgram&) override { return false; }

private:
    friend base::Result<ProgramFolder, base::Error> open_program_folder(std::string_view);
    base::FixedString<1023> path_;
    std::unique_ptr<unsigned char[]> bytes_;
};

/// Refused in one sentence where there is no such folder.
[[nodiscard]] base::Result<ProgramFolder, base::Error> open_program_folder(std::string_view path);

}  // namespace tedavis::platform
