#include "platform/current_surface.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace tedavis::platform::test_current_surface {
namespace {

class Plain final : public base::Surface {
public:
    std::uint32_t width() const override { return 16; }
    std::uint32_t height() const override { return 16; }
    bool make_current() override { return claim_current(this); }
    void release_current() override { drop_current(this); }
    void* proc_address(const char*) override { return nullptr; }
    base::SurfaceState present() override { return base::SurfaceState::ready; }
    const char* backend_name() const override { return "plain"; }
};

TEST(CurrentSurface, IsOneAtATime) {
    Plain a, b;
    EXPECT_FALSE(any_current());
    EXPECT_TRUE(a.make_current());
    EXPECT_TRUE(is_current(&a));
    EXPECT_FALSE(b.make_current());
    b.release_current();
    EXPECT_TRUE(is_current(&a)) << "only its holder releases it";
    a.release_current();
    EXPECT_FALSE(any_current());
    EXPECT_TRUE(b.make_current());
    b.release_current();
}

TEST(CurrentSurface, EachThreadHasItsOwn) {
    Plain a, b;
    ASSERT_TRUE(a.make_current());
    bool other = false;
    std::thread thread([&] {
        other = b.make_current();
        b.release_current();
    });
    thread.join();
    EXPECT_TRUE(other);
    EXPECT_TRUE(is_current(&a));
    a.release_current();
}

}  // namespace
}  // namespace tedavis::platform::test_current_surface
