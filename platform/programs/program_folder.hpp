/// A folder of linked shader programs, one file each, for a device without a shader compiler: `tedavis shaders` writes it, or on
/// the board itself `tedavis-display --write-shaders`.
///
/// File    "<16 hex digits of the key>.program": magic "TEDPROG1", CRC-32 of all bytes after it, format, key (little-endian
///         u32, u32, u64), then the driver's binary up to the file's end.
/// Memory  room for one binary, allocated by open_program_folder(). Thread  one.
#pragma once

#include <memory>
#include <string_view>

#include "render_core/base/error.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/ports/program_store.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

/// Upper limit of a program's binary, far above those of known drivers.
inline constexpr std::size_t kMaxProgramBytes = std::size_t{4} << 20;
inline constexpr std::size_t kProgramHeaderBytes = 24;

/// Writes the part of the file that precedes the binary.
void write_program_header(std::uint64_t key, const base::StoredProgram& program, unsigned char (&header)[kProgramHeaderBytes]);
[[nodiscard]] base::FixedString<31> program_file_name(std::uint64_t key);

class ProgramFolder final : public base::ProgramStore {
public:
    ProgramFolder() = default;

    /// Returns false for a missing, damaged or truncated file.
    [[nodiscard]] bool find(std::uint64_t key, base::StoredProgram& program) override;
    /// Always empty: this store is read-only, because programs are made on a desktop computer.
    [[nodiscard]] base::Span<unsigned char> room(std::size_t) override { return {}; }
    [[nodiscard]] bool keep(std::uint64_t, std::string_view, const base::StoredProgram&) override { return false; }

private:
    friend base::Result<ProgramFolder, base::Error> open_program_folder(std::string_view);
    base::FixedString<1023> path_;
    std::unique_ptr<unsigned char[]> bytes_;
};

/// Fails with one sentence where there is no such folder.
[[nodiscard]] base::Result<ProgramFolder, base::Error> open_program_folder(std::string_view path);

}  // namespace tedavis::platform
