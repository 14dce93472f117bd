// Times CGAL's Delaunay_mesh_2 at the bound of 30 degrees: planar_peer_cgal square|annulus SIZE. One line of JSON.
// It shares nothing with our core. The annulus is given as polylines with edges of the wanted size.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <list>
#include <string_view>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Storage = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                                     CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Storage>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;

void addLoop(Triangulation& triangulation, const std::vector<Kernel::Point_2>& points)
{
    std::vector<Triangulation::Vertex_handle> handles;
    for (const auto& p : points) handles.push_back(triangulation.insert(p));
    for (std::size_t i = 0; i < handles.size(); ++i) {
        triangulation.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
    }
}

std::vector<Kernel::Point_2> circle(double radius, double size)
{
    const double turn = 2.0 * std::acos(-1.0);
    const int count = static_cast<int>(std::ceil(turn * radius / size));
    std::vector<Kernel::Point_2> points;
    for (int i = 0; i < count; ++i) {
        points.emplace_back(radius * std::cos(turn * i / count), radius * std::sin(turn * i / count));
    }
    return points;
}

int main(int count, char** words)
{
    if (count != 3) {
        std::cerr << "planar_peer_cgal square|annulus SIZE\n";
        return 2;
    }
    const double size = std::strtod(words[2], nullptr);
    const bool isSquare = std::string_view(words[1]) == "square";
    const auto start = std::chrono::steady_clock::now();
    Triangulation triangulation;
    std::list<Kernel::Point_2> seeds;
    if (isSquare) {
        addLoop(triangulation, {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}});
    } else {
        addLoop(triangulation, circle(2.0, size));
        addLoop(triangulation, circle(1.0, size));
        seeds.emplace_back(0.0, 0.0);
    }
    CGAL::Delaunay_mesher_2<Triangulation, Criteria> mesher(triangulation, Criteria(0.25, size));
    mesher.set_seeds(seeds.begin(), seeds.end());
    mesher.refine_mesh();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::size_t triangles = 0;
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
        if (face->is_in_domain()) ++triangles;
    }
    std::cout << "{\"triangles\": " << triangles << ", \"vertices\": " << triangulation.number_of_vertices()
              << ", \"seconds\": " << seconds
              << ", \"triangles_per_second\": " << static_cast<double>(triangles) / seconds << "}\n";
    return 0;
}
