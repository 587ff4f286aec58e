// What a card lists is shown on an emulated one (tests/board); here is what is no card.
#include "platform/egl_kms/drm_inventory.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::platform::test_drm_inventory {
namespace {

#if defined(TEDAVIS_HAVE_KMS)

/// A folder that stands for /dev/dri, with plain files.
struct DrmInventory : testing::Test {
    void make(const std::string& name) { (void)place.write(name, ""); }
    test_support::TemporaryFolder place;
    std::string folder = place.path();
    std::unique_ptr<ScreenInventory> inventory = std::make_unique<ScreenInventory>();
};

TEST_F(DrmInventory, HasEveryCardInTheOrderOfNumbersAndNothingElse) {
    for (const char* name : {"card10", "card2", "card1", "renderD128", "cardx", "card", "card3-x", "by-path"}) make(name);
    list_screens("", *inventory, folder.c_str());
    ASSERT_EQ(inventory->cards.size(), 3u);
    EXPECT_EQ(inventory->cards[0].path.view(), folder + "/card1");
    EXPECT_EQ(inventory->cards[1].path.view(), folder + "/card2");
    EXPECT_EQ(inventory->cards[2].path.view(), folder + "/card10");
    for (const ScreenCard& card : inventory->cards) {
        EXPECT_EQ(card.access, CardAccess::no_screens) << "a plain file is no card";
        EXPECT_TRUE(card.driver.empty());
    }
}

TEST_F(DrmInventory, ANamedCardStandsAlone) {
    make("card1");
    list_screens(folder + "/other", *inventory, folder.c_str());
    ASSERT_EQ(inventory->cards.size(), 1u);
    EXPECT_EQ(inventory->cards[0].access, CardAccess::missing);
    list_screens("/dev/null", *inventory, folder.c_str());
    ASSERT_EQ(inventory->cards.size(), 1u) << "the list is made anew";
    EXPECT_EQ(inventory->cards[0].access, CardAccess::no_screens);
}

TEST_F(DrmInventory, WithoutTheFolderThereIsNoCard) {
    list_screens("", *inventory, (folder + "/absent").c_str());
    EXPECT_TRUE(inventory->cards.empty());
    list_screens("", *inventory, folder.c_str());
    EXPECT_TRUE(inventory->cards.empty());
}

#endif

}  // namespace
}  // namespace tedavis::platform::test_drm_inventory
