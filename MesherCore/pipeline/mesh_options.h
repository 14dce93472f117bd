#pragma once

#include "base/result.h"
#include "pipeline/size_wishes.h"
#include "quality/tet_measures.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mesher {

/// What happens to solids that overlap.
enum class OverlapChoice : std::uint8_t
{
    Separate,  ///< each is meshed for itself, with a warning
    Refuse     ///< the run fails with their names
};

/// "separate", "refuse".
[[nodiscard]] std::string_view nameOf(OverlapChoice choice);
/// Nothing for another word.
[[nodiscard]] std::optional<OverlapChoice> overlapChoiceOf(std::string_view name);

/// Everything a user may ask of a mesh; what has no value is left to the mesher.
struct MeshOptions
{
    int dimension = 3;               ///< 2 the planar faces, 3 the solids. DEFAULT: 3
    std::vector<std::string> faces;  ///< what is meshed in two dimensions: "Face6", … DEFAULT: all

    /// \name Size (mean edge on curves and surfaces, model units; see sizing/size_bounds.h)
    ///@{
    std::optional<double>
        size;  ///< where nothing asks for less; > 0. DEFAULT: only as small as shape and quality want
    std::optional<double> minSize;  ///< none is asked to be smaller; > 0, at most `size`. DEFAULT: none
    double curvature = 0.0;         ///< elements in a full turn of a curve, 0 (off) or 3 … 3600. DEFAULT: 0
    double sag = 0.0;               ///< largest distance of an edge from its curve; 0 is off. DEFAULT: 0
    /// R: boundary size is local feature size / R; 1 … 1000. DEFAULT: 1 on plane faces, in space no size by features
    std::optional<double> refinement;
    double grading = 1.0;  ///< G: sizes grow by at most distance / G; 0.01 … 1000. DEFAULT: 1
    std::vector<LocalSize> localSizes;
    std::vector<SizeByDistance> distanceSizes;
    std::vector<SizeInBox> boxSizes;
    std::vector<SizeInBall> ballSizes;
    std::string sizeFormula;  ///< of x, y, z, see FormulaSize. DEFAULT: none
    std::string sizePoints;   ///< text file with lines "x y z size". DEFAULT: none
    std::string background;   ///< .msh or .vtu file with a number at each node, the size. DEFAULT: none
    ///@}

    /// \name Quality
    ///@{
    double minAngle = 30.0;  ///< of triangles, degrees, 0 … 45; proven to end up to 25.7. DEFAULT: 30
    double maxTurn = 90.0;   ///< of the tangent along an edge of a curve, degrees, 30 … 90. DEFAULT: 90
    TetMeasure measure = TetMeasure::MinimumDihedralSine;  ///< of tetrahedra. DEFAULT: q2
    std::optional<double>
        threshold;  ///< score below which a tetrahedron is refined; (0, 1]. DEFAULT: of the measure
    /// Dihedral angle above which a tetrahedron is refined whatever it scores, degrees, 120 … 180 (off). DEFAULT: of the measure
    std::optional<double> maxDihedral;
    /// How far below the length scale of a place refinement for quality goes before all else is done; 1 … 1e8. DEFAULT: of the measure
    std::optional<double> lambda;
    bool isImproved = true;  ///< DEFAULT: true
    int order = 1;           ///< of elements, 1 or 2. DEFAULT: 1
    ///@}

    /// \name Run
    ///@{
    unsigned threads = 1;                    ///< 1 … 1024; the mesh does not depend on it. DEFAULT: 1
    std::uint64_t maxElements = 50'000'000;  ///< 1 … 10^9; the run ends there. DEFAULT: 50 million
    /// Tetrahedra that thin walls, gaps and cusps may take beyond those of the sizes; those that take more are left with flat
    /// ones. 0 … 10^9. DEFAULT: about as many as the sizes ask for in the whole model
    std::optional<std::uint64_t> maxWallElements;
    OverlapChoice overlap = OverlapChoice::Separate;  ///< DEFAULT: Separate
    std::optional<double> timeout;                    ///< seconds, > 0. DEFAULT: none
    bool isChecked = false;  ///< the mesh is checked as a whole before it is handed out. DEFAULT: false
    ///@}
};

/// Refuses, with the option's name and range, values that make no sense: zero, negative and infinite sizes, what is not a number.
[[nodiscard]] Result<void> validate(const MeshOptions& options);

}  // namespace mesher
