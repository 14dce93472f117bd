#include "pipeline/mesh_report.h"

#include "support/sample_meshes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mesher {
namespace {

TEST(MeshReport, HasTheKeysThatProgramsReadOfAVolumeMesh)
{
    MeshReport report;
    report.seconds = {{"reading", 0.5}};
    report.cpuSeconds = {{"reading", 0.25}};
    report.failures = {{ErrorCode::InvalidArgument, "is \"odd\"", "Face6", Vec3{1.0, 2.0, 3.0}, "mend it"}};
    describeMesh(test::twoSolidMesh(), report);
    const auto json = nlohmann::json::parse(toJson(report));
    EXPECT_EQ(json["status"], "done");
    EXPECT_EQ(json["stop_reason"], "done");
    EXPECT_EQ(json["failures"][0]["entity"], "Face6");
    EXPECT_EQ(json["failures"][0]["point"], (std::vector<double>{1.0, 2.0, 3.0}));
    EXPECT_EQ(json["failures"][0]["reason"], "is \"odd\"");
    EXPECT_EQ(json["failures"][0]["remedy"], "mend it");
    EXPECT_EQ(json["seconds"]["reading"], 0.5);
    EXPECT_EQ(json["cpu_seconds"]["reading"], 0.25);
    EXPECT_EQ(json["counts"]["tets"], 96);
    EXPECT_NEAR(json["quality"]["min_dihedral"].get<double>(), 45.0, 1e-9);
    EXPECT_NEAR(json["quality"]["max_dihedral"].get<double>(), 90.0, 1e-9);
    EXPECT_EQ(json["quality"]["dihedral_histogram"].size(), 18u);
    EXPECT_EQ(json["quality"]["measure"], "q2");
    EXPECT_EQ(json["quality"]["threshold"], 0.32);
    EXPECT_NEAR(json["mesh"]["volume"].get<double>(), 0.016, 1e-15);
    EXPECT_EQ(json["mesh_hash"].get<std::string>().size(), 16u);
    EXPECT_EQ(json["options"]["dimension"], 3);
    EXPECT_TRUE(json["options"]["size"].is_null());
    EXPECT_TRUE(json.contains("versions") && json.contains("model"));
}

TEST(MeshReport, SpeaksOfOverlapOnlyWhereItIsAskedFor)
{
    MeshReport report;
    EXPECT_EQ(toJson(report).find("overlap"), std::string::npos);
    report.options.overlap = OverlapChoice::Refuse;
    EXPECT_EQ(nlohmann::json::parse(toJson(report))["options"]["overlap"], "refuse");
}

TEST(MeshReport, ListsTheFirstPlacesOfElementsLeftBad)
{
    MeshReport report;
    for (std::uint64_t i = 0; i < 60; ++i)
        report.left.push_back({"Face1 and Face2 meet at Edge3 at 12 degrees",
                               {"Edge3"},
                               100 - i,
                               3.5,
                               170.0,
                               {1, 2, 3},
                               "round it"});
    const auto left = nlohmann::json::parse(toJson(report))["left"];
    EXPECT_EQ(left["count"], 60 * 100 - 59 * 60 / 2);
    ASSERT_EQ(left["places"].size(), 50u);
    std::uint64_t listed = 0;
    for (const auto& place : left["places"]) listed += place["count"].get<std::uint64_t>();
    EXPECT_EQ(left["not_listed"], left["count"].get<std::uint64_t>() - listed);
    EXPECT_EQ(left["places"][0]["entities"], std::vector<std::string>{"Edge3"});
    EXPECT_EQ(left["places"][0]["min_dihedral"], 3.5);
    EXPECT_EQ(left["places"][0]["point"], (std::vector<double>{1.0, 2.0, 3.0}));
}

TEST(MeshReport, ListsFacesThatAreNotDelaunay)
{
    MeshReport report;
    report.nonDelaunay = {{"they bend", {"Face1", "Face2"}, 7, {1, 2, 3}, "take smaller ones"},
                          {"they tie", {}, 2, {}, "none is needed"}};
    const auto json = nlohmann::json::parse(toJson(report))["not_delaunay"];
    EXPECT_EQ(json["count"], 9);
    EXPECT_EQ(json["not_listed"], 0);
    ASSERT_EQ(json["places"].size(), 2u);
    EXPECT_EQ(json["places"][0]["entities"], (std::vector<std::string>{"Face1", "Face2"}));
    EXPECT_EQ(json["places"][0]["reason"], "they bend");
    EXPECT_EQ(json["places"][0]["count"], 7);
    EXPECT_EQ(json["places"][0]["point"], (std::vector<double>{1.0, 2.0, 3.0}));
    EXPECT_EQ(json["places"][1]["remedy"], "none is needed");
}

TEST(MeshReport, HasAnglesOfAPlaneMesh)
{
    MeshReport report;
    describeMesh(test::twoFaceMesh(), report);
    const auto json = nlohmann::json::parse(toJson(report));
    EXPECT_NEAR(json["quality"]["min_angle"].get<double>(), 45.0, 1e-9);
    EXPECT_EQ(json["quality"]["angle_histogram"].size(), 18u);
    EXPECT_NEAR(json["mesh"]["area"].get<double>(), 0.32, 1e-12);
}

TEST(MeshReport, SurvivesPathsThatAreNoText)
{
    MeshReport report;
    report.modelFile = "\xff\xfe.step";
    const auto json = nlohmann::json::parse(toJson(report));
    EXPECT_NE(json["model"]["file"].get<std::string>().find(".step"), std::string::npos);
}

}  // namespace
}  // namespace mesher
