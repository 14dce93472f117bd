#include "io/atomic_file.h"

#include "io/mesh_writer.h"
#include "support/sample_meshes.h"
#include "support/temp_dir.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <future>
#include <sstream>
#include <thread>
#include <vector>

namespace mesher {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void put(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

std::size_t fileCount(const fs::path& folder)
{
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(AtomicFile, ReplacesTheTargetOnlyWhenCommitted)
{
    const test::TempDir folder;
    const fs::path target = folder.path() / "file";
    put(target, "old");
    {
        Result<AtomicFile> file = AtomicFile::create(target);
        ASSERT_TRUE(file);
        ASSERT_TRUE(file->write(std::string_view("new")));
        EXPECT_EQ(contentOf(target), "old");
    }
    EXPECT_EQ(contentOf(target), "old");
    EXPECT_EQ(fileCount(folder.path()), 1u);
    Result<AtomicFile> file = AtomicFile::create(target);
    ASSERT_TRUE(file && file->write(std::string_view("new")) && file->commit());
    EXPECT_EQ(contentOf(target), "new");
    EXPECT_EQ(fileCount(folder.path()), 1u);
}

TEST(AtomicFile, KeepsThePermissionsOfWhatItReplaces)
{
    const test::TempDir folder;
    const fs::path target = folder.path() / "file";
    put(target, "old");
    fs::permissions(target, fs::perms::owner_all | fs::perms::group_read);
    Result<AtomicFile> file = AtomicFile::create(target);
    ASSERT_TRUE(file && file->commit());
    EXPECT_EQ(fs::status(target).permissions(), fs::perms::owner_all | fs::perms::group_read);
    Result<AtomicFile> fresh = AtomicFile::create(folder.path() / "fresh");
    ASSERT_TRUE(fresh && fresh->commit());
    const mode_t mask = umask(0);
    umask(mask);
    EXPECT_EQ(static_cast<mode_t>(fs::status(folder.path() / "fresh").permissions()), 0666u & ~mask);
}

TEST(AtomicFile, WritesThroughALinkAndKeepsIt)
{
    const test::TempDir folder;
    put(folder.path() / "target", "old");
    fs::create_symlink("target", folder.path() / "link");
    Result<AtomicFile> file = AtomicFile::create(folder.path() / "link");
    ASSERT_TRUE(file && file->write(std::string_view("new")) && file->commit());
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
    EXPECT_EQ(contentOf(folder.path() / "target"), "new");
}

TEST(AtomicFile, MakesWhatALinkPointsToThatIsNotThereYet)
{
    const test::TempDir folder;
    fs::create_directory(folder.path() / "far");
    fs::create_symlink("far/second", folder.path() / "first");
    fs::create_symlink("target", folder.path() / "far" / "second");
    Result<AtomicFile> file = AtomicFile::create(folder.path() / "first");
    ASSERT_TRUE(file && file->write(std::string_view("new")) && file->commit());
    EXPECT_TRUE(fs::is_symlink(folder.path() / "first") && fs::is_symlink(folder.path() / "far" / "second"));
    EXPECT_EQ(contentOf(folder.path() / "far" / "target"), "new");
    fs::create_symlink("loop", folder.path() / "loop");
    EXPECT_FALSE(AtomicFile::create(folder.path() / "loop"));
}

TEST(AtomicFile, HasNoNameBeforeItIsPublished)
{
    const test::TempDir folder;
    put(folder.path() / "file", "old");
    Result<AtomicFile> file = AtomicFile::create(folder.path() / "file");
    ASSERT_TRUE(file && file->write(std::string_view("new")) && file->prepare());
    EXPECT_EQ(fileCount(folder.path()), 1u);
}

TEST(AtomicFile, OfSeveralAllAppearOrNone)
{
    const test::TempDir folder;
    put(folder.path() / "old", "old");
    fs::create_directory(folder.path() / "gone");
    std::vector<AtomicFile> files;
    for (const char* name : {"old", "new", "gone/third"}) {
        Result<AtomicFile> file = AtomicFile::create(folder.path() / name);
        ASSERT_TRUE(file && file->write(std::string_view("content")) && file->prepare());
        files.push_back(std::move(file).value());
    }
    fs::remove(folder.path() / "gone");
    const Result<void> published = publishAll(files);
    ASSERT_FALSE(published);
    EXPECT_NE(describe(published.error()).find("third"), std::string::npos);
    EXPECT_EQ(contentOf(folder.path() / "old"), "old");
    EXPECT_EQ(fileCount(folder.path()), 1u);
}

TEST(AtomicFile, RefusesAPipeThatNobodyReads)
{
    const test::TempDir folder;
    const fs::path pipe = folder.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const Result<void> written = writeMesh(test::twoFaceMesh(), pipe, "msh");
    ASSERT_FALSE(written);
    EXPECT_NE(describe(written.error()).find("read by no program"), std::string::npos);
    EXPECT_TRUE(fs::is_fifo(pipe));
}

/// More than a pipe holds at once.
TEST(AtomicFile, FillsAPipeThatIsRead)
{
    const test::TempDir folder;
    const fs::path pipe = folder.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::string got;
    std::promise<void> isOpen;
    std::thread reader([&] {
        const int descriptor = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
        isOpen.set_value();
        char block[4096];
        for (ssize_t count = -1; count != 0 || got.empty();) {
            count = read(descriptor, block, sizeof block);
            if (count > 0) got.append(block, static_cast<std::size_t>(count));
            if (count <= 0) std::this_thread::yield();
        }
        close(descriptor);
    });
    isOpen.get_future().wait();
    EXPECT_TRUE(writeMesh(test::twoFaceMesh(100), pipe, "msh"));
    reader.join();
    ASSERT_TRUE(writeMesh(test::twoFaceMesh(100), folder.path() / "file", "msh"));
    EXPECT_EQ(got, contentOf(folder.path() / "file"));
}

void expectRefused(const fs::path& target, const std::string& part)
{
    const Result<void> probed = AtomicFile::probe(target);
    ASSERT_FALSE(probed) << target;
    EXPECT_EQ(probed.error().code, ErrorCode::Unwritable);
    EXPECT_NE(describe(probed.error()).find(part), std::string::npos) << describe(probed.error());
    EXPECT_FALSE(probed.error().remedy.empty());
    EXPECT_FALSE(AtomicFile::create(target)) << target;
    EXPECT_FALSE(writeMesh(test::twoFaceMesh(), target, "msh")) << target;
}

TEST(AtomicFile, RefusesPlacesThatCannotBeWritten)
{
    const test::TempDir folder;
    put(folder.path() / "file", "");
    expectRefused(folder.path(), "folder");
    expectRefused(folder.path() / "", "folder");
    expectRefused(folder.path() / "missing" / "mesh.msh", "does not exist");
    expectRefused(folder.path() / "file" / "mesh.msh", "not");
    expectRefused("", "empty");
    EXPECT_EQ(fileCount(folder.path()), 1u);
}

TEST(AtomicFile, RefusesAFolderThatMayNotBeWritten)
{
    if (access("/proc/version", W_OK) == 0) GTEST_SKIP() << "nothing is write-protected here";
    expectRefused("/proc/mesh.msh", "");
}

TEST(AtomicFile, TellsThatADiskIsFull)
{
    if (!fs::exists("/dev/full")) GTEST_SKIP();
    for (const MeshFormat& format : meshFormats()) {
        const Result<void> written = writeMesh(test::twoFaceMesh(6), "/dev/full", format.name);
        ASSERT_FALSE(written) << format.name;
        EXPECT_EQ(written.error().code, ErrorCode::Unwritable);
        EXPECT_NE(describe(written.error()).find("space"), std::string::npos) << describe(written.error());
    }
    EXPECT_TRUE(writeMesh(test::twoFaceMesh(), "/dev/null", "msh"));
}

/// A limit on the size of files stands for a disk that fills up in the middle.
TEST(AtomicFile, LeavesTheOldFileAndNothingElseWhenItFails)
{
    const test::TempDir folder;
    const fs::path target = folder.path() / "mesh.msh";
    put(target, "old");
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small = {1u << 20, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const Result<void> written = writeMesh(test::twoFaceMesh(150), target);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, oldHandler);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::Unwritable);
    EXPECT_EQ(contentOf(target), "old");
    EXPECT_EQ(fileCount(folder.path()), 1u);
}

}  // namespace
}  // namespace mesher
