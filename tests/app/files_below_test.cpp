#include "app/files/files_below.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "sim/base/errors.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

TEST(FilesBelow, AreThoseOfLinkedFoldersToo)
{
    test::TempFolder folder, elsewhere;
    std::filesystem::create_directories(folder.path("one/two"));
    folder.write("one/two/a.png", "");
    folder.write("b.png", "");
    elsewhere.write("c.png", "");
    std::filesystem::create_directory_symlink(elsewhere.path(), folder.path("one/linked"));
    std::filesystem::create_directory_symlink(folder.path("one"), folder.path("one/two/around"));
    std::filesystem::create_symlink(folder.path("nowhere"), folder.path("gone"));
    EXPECT_EQ(filesBelow(folder.path()), (std::set<std::string>{"b.png", "gone", "one/linked/c.png", "one/two/a.png"}));
    EXPECT_THROW(filesBelow(folder.path("none")), InputError);
}

}  // namespace
}  // namespace knuckle
