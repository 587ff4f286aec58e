// What every ByteSource must do, run on the file and on memory.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "platform/files/file_byte_source.hpp"
#include "platform/files/memory_byte_source.hpp"

namespace tedavis::platform::test_byte_source_contract {
namespace {

constexpr std::size_t kSize = 100'003;

std::vector<unsigned char> content() {
    std::vector<unsigned char> bytes(kSize);
    for (std::size_t i = 0; i < kSize; ++i) bytes[i] = static_cast<unsigned char>(i * i >> 3);
    return bytes;
}

/// Holds what the source reads from.
struct Medium {
    virtual ~Medium() = default;
    virtual base::ByteSource& source() = 0;
};

struct FileMedium final : Medium {
    FileMedium() {
        const auto bytes = content();
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        auto opened = open_file(path.c_str());
        EXPECT_TRUE(opened.ok());
        file = std::move(opened.value());
    }
    ~FileMedium() override { std::remove(path.c_str()); }
    base::ByteSource& source() override { return file; }
    const std::string path = testing::TempDir() + "tedavis_bytes_" + std::to_string(getpid());
    FileByteSource file;
};

struct MemoryMedium final : Medium {
    base::ByteSource& source() override { return memory; }
    const std::vector<unsigned char> bytes = content();
    MemoryByteSource memory{base::Span<const unsigned char>(bytes.data(), bytes.size())};
};

class ByteSourceContract : public testing::TestWithParam<const char*> {
protected:
    ByteSourceContract() {
        if (std::string(GetParam()) == "file") {
            medium_ = std::make_unique<FileMedium>();
        } else {
            medium_ = std::make_unique<MemoryMedium>();
        }
    }
    base::ByteSource& source() { return medium_->source(); }
    const std::vector<unsigned char> expected_ = content();
    std::unique_ptr<Medium> medium_;
};

TEST_P(ByteSourceContract, ReadsAnyPart) {
    EXPECT_EQ(source().size(), kSize);
    for (std::size_t offset : {std::size_t{0}, std::size_t{1}, std::size_t{4096}, kSize - 7}) {
        std::vector<unsigned char> part(7);
        ASSERT_TRUE(source().read(offset, part.data(), part.size()));
        EXPECT_TRUE(std::equal(part.begin(), part.end(), expected_.begin() + static_cast<std::ptrdiff_t>(offset))) << offset;
    }
    std::vector<unsigned char> whole(kSize);
    ASSERT_TRUE(source().read(0, whole.data(), kSize));
    EXPECT_EQ(whole, expected_);
}

TEST_P(ByteSourceContract, RefusesWhatIsNotAllThere) {
    std::vector<unsigned char> part(kSize + 1);
    EXPECT_FALSE(source().read(kSize, part.data(), 1));
    EXPECT_FALSE(source().read(kSize - 1, part.data(), 2));
    EXPECT_FALSE(source().read(0, part.data(), kSize + 1));
    EXPECT_FALSE(source().read(std::numeric_limits<std::uint64_t>::max(), part.data(), 2)) << "must not wrap around";
    EXPECT_TRUE(source().read(kSize, part.data(), 0));
    EXPECT_FALSE(source().read(kSize + 1, part.data(), 0));
}

TEST_P(ByteSourceContract, ServesManyThreads) {
    std::vector<std::thread> threads;
    std::atomic<int> wrong{0};
    for (std::size_t t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            std::vector<unsigned char> part(64);
            for (std::size_t offset = t; offset + 64 < kSize; offset += 977) {
                const bool good = source().read(offset, part.data(), 64) &&
                                  std::equal(part.begin(), part.end(), expected_.begin() + static_cast<std::ptrdiff_t>(offset));
                if (!good) ++wrong;
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
}

INSTANTIATE_TEST_SUITE_P(Media, ByteSourceContract, testing::Values("file", "memory"),
                         [](const auto& medium) { return std::string(medium.param); });

}  // namespace
}  // namespace tedavis::platform::test_byte_source_contract
