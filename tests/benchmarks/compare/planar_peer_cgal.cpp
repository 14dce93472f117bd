// Times CGAL's Delaunay_mesh_2 on polylines at the bound of 30 degrees: planar_peer_cgal OUTLINE SIZE|0. One line of JSON.
// It shares nothing with our core. The outline has lines "v X Y", "e I J" and "s X Y", a point in each hole; SIZE is the
// longest edge allowed, 0 asks for quality alone.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <list>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Storage = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                                     CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Storage>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
using Point = Kernel::Point_2;

struct Outline
{
    std::vector<Point> vertices;
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    std::list<Point> inHoles;
};

Outline readOutline(const char* path)
{
    Outline outline;
    std::ifstream file(path);
    char kind = 0;
    double x = 0.0;
    double y = 0.0;
    while (file >> kind >> x >> y) {
        if (kind == 'v') outline.vertices.emplace_back(x, y);
        if (kind == 'e') outline.edges.emplace_back(static_cast<std::size_t>(x), static_cast<std::size_t>(y));
        if (kind == 's') outline.inHoles.emplace_back(x, y);
    }
    return outline;
}

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Largest resident size of this process so far, bytes.
double peakMemory()
{
    // Not getrusage: its maximum is inherited from the process that started this one.
    std::ifstream status("/proc/self/status");
    std::string word;
    double kibibytes = 0.0;
    while (status >> word) {
        if (word == "VmHWM:" && status >> kibibytes) break;
    }
    return 1024.0 * kibibytes;
}

/// The smallest and the largest angle of a triangle, degrees.
std::pair<double, double> anglesOf(const Triangulation::Face& face)
{
    std::pair<double, double> range{180.0, 0.0};
    for (int i = 0; i < 3; ++i) {
        const auto u = face.vertex((i + 1) % 3)->point() - face.vertex(i)->point();
        const auto v = face.vertex((i + 2) % 3)->point() - face.vertex(i)->point();
        const double angle = std::atan2(u.x() * v.y() - u.y() * v.x(), u * v) * 180.0 / std::acos(-1.0);
        range = {std::min(range.first, angle), std::max(range.second, angle)};
    }
    return range;
}

int main(int count, char** words)
{
    if (count != 3) {
        std::cerr << "planar_peer_cgal OUTLINE SIZE|0\n";
        return 2;
    }
    const Outline outline = readOutline(words[1]);
    const double memoryBefore = peakMemory();
    const double start = cpuSeconds();
    Triangulation triangulation;
    std::vector<Triangulation::Vertex_handle> handles;
    for (const Point& p : outline.vertices) handles.push_back(triangulation.insert(p));
    for (const auto& [first, last] : outline.edges)
        triangulation.insert_constraint(handles[first], handles[last]);
    CGAL::Delaunay_mesher_2<Triangulation, Criteria> mesher(triangulation,
                                                            Criteria(0.25, std::strtod(words[2], nullptr)));
    mesher.set_seeds(outline.inHoles.begin(), outline.inHoles.end());
    mesher.refine_mesh();
    const double seconds = cpuSeconds() - start;
    const double memory = peakMemory() - memoryBefore;
    std::size_t triangles = 0;
    std::pair<double, double> angles{180.0, 0.0};
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
        if (!face->is_in_domain()) continue;
        ++triangles;
        const auto range = anglesOf(*face);
        angles = {std::min(angles.first, range.first), std::max(angles.second, range.second)};
    }
    std::cout << "{\"triangles\": " << triangles << ", \"vertices\": " << triangulation.number_of_vertices()
              << ", \"cpu_seconds\": " << seconds
              << ", \"peak_bytes_per_triangle\": " << memory / static_cast<double>(triangles)
              << ", \"min_angle\": " << angles.first << ", \"max_angle\": " << angles.second << "}\n";
    return 0;
}
