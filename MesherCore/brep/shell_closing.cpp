#include "brep/shell_closing.h"

#include "base/indexed_map.h"
#include "brep/face_distance.h"
#include "brep/face_integral.h"
#include "brep/name_list.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mesher {

namespace {

/// Faces that are joined by edges, each with the way it looks.
struct Patch
{
    std::vector<BrepShellFace> faces;
    bool isClosed = false;
    double volume = 0.0;
    std::vector<std::size_t> around;  ///< closed patches that it is inside of
};

/// A face's use of an edge.
struct EdgeUse
{
    BrepFaceId face;
    bool isReversed = false;
};

class ShellClosing
{
public:
    explicit ShellClosing(BrepModel& model) : model_(model), usesOf_(model.edges.size()) {}

    void run()
    {
        closeSolids();
        if (model_.looseShells.empty()) return;
        findLooseFaces();
        findPatches();
        model_.looseShells.clear();
        for (Patch& patch : patches_) {
            if (!patch.isClosed) model_.looseShells.push_back({patch.faces, false});
        }
        std::erase_if(patches_, [](const Patch& patch) { return !patch.isClosed; });
        for (Patch& patch : patches_) turnOutward(patch);
        for (std::size_t i = 0; i < patches_.size(); ++i) findAround(i);
        for (std::size_t i = 0; i < patches_.size(); ++i) {
            if (!isVoid(i)) makeSolid(i);
        }
    }

private:
    /// Shells of solids whose edges have two faces each since they were sewn are closed; open ones beside a closed one bound nothing.
    void closeSolids()
    {
        for (std::uint32_t s = 0; s < model_.solids.size(); ++s) {
            std::vector<BrepShell>& shells = model_.solids[BrepSolidId(s)].shells;
            for (BrepShell& shell : shells) shell.isClosed = shell.isClosed || hasTwoFacesAtEachEdge(shell);
            const auto firstOpen = std::stable_partition(
                shells.begin(), shells.end(), [](const BrepShell& shell) { return shell.isClosed; });
            if (firstOpen == shells.begin()) continue;
            model_.looseShells.insert(model_.looseShells.end(), firstOpen, shells.end());
            shells.erase(firstOpen, shells.end());
        }
    }

    [[nodiscard]] bool hasTwoFacesAtEachEdge(const BrepShell& shell) const
    {
        IndexedMap<BrepEdgeId, int> uses;
        for (const BrepShellFace& use : shell.faces) {
            for (const BrepLoop& loop : model_.faces[use.face].loops) {
                for (const BrepCoedge& coedge : loop.coedges) {
                    if (!model_.edges[coedge.edge].isDegenerate) ++uses[coedge.edge];
                }
            }
        }
        bool isClosed = !shell.faces.empty();
        for (const auto& use : uses) isClosed = isClosed && use.value == 2;
        return isClosed;
    }

    /// A face may be in several shells, and beside that in a solid.
    void findLooseFaces()
    {
        IdVector<BrepFaceId, std::uint8_t> isKnown(model_.faces.size());
        for (const BrepSolid& solid : model_.solids) {
            for (const BrepShell& shell : solid.shells) {
                for (const BrepShellFace& use : shell.faces) isKnown[use.face] = 1;
            }
        }
        for (const BrepShell& shell : model_.looseShells) {
            for (const BrepShellFace& use : shell.faces) {
                if (isKnown[use.face] == 0) loose_.push_back(use);
                isKnown[use.face] = 1;
            }
        }
        for (const BrepShellFace& use : loose_) {
            for (const BrepLoop& loop : model_.faces[use.face].loops) {
                for (const BrepCoedge& coedge : loop.coedges)
                    usesOf_[coedge.edge].push_back({use.face, coedge.isReversed});
            }
        }
    }

    void findPatches()
    {
        IdVector<BrepFaceId, std::uint8_t> isSeen(model_.faces.size());
        for (const BrepShellFace& first : loose_) {
            if (isSeen[first.face] != 0) continue;
            Patch patch;
            patch.isClosed = true;
            std::deque<BrepShellFace> open = {first};
            isSeen[first.face] = 1;
            way_.resize(model_.faces.size());
            for (; !open.empty(); open.pop_front()) {
                patch.faces.push_back(open.front());
                way_[open.front().face] = open.front().isReversed ? 1 : 0;
                patch.isClosed = spread(open.front(), isSeen, open) && patch.isClosed;
            }
            patch.isClosed = patch.isClosed && isConsistent(patch);
            patches_.push_back(std::move(patch));
        }
    }

    /// The faces beside one, turned so that the edge is run along in both directions. False if some edge has another number of
    /// faces than two.
    bool spread(BrepShellFace from, IdVector<BrepFaceId, std::uint8_t>& isSeen,
                std::deque<BrepShellFace>& open) const
    {
        bool isClosed = true;
        for (const BrepLoop& loop : model_.faces[from.face].loops) {
            for (const BrepCoedge& coedge : loop.coedges) {
                if (model_.edges[coedge.edge].isDegenerate) continue;
                const std::vector<EdgeUse>& uses = usesOf_[coedge.edge];
                isClosed = isClosed && uses.size() == 2;
                for (const EdgeUse& use : uses) {
                    if (isSeen[use.face] != 0) continue;
                    isSeen[use.face] = 1;
                    const bool turns = use.isReversed == coedge.isReversed;
                    open.push_back({use.face, from.isReversed != turns});
                }
            }
        }
        return isClosed;
    }

    [[nodiscard]] bool isConsistent(const Patch& patch) const
    {
        const auto runsBack = [&](const EdgeUse& use) { return use.isReversed != (way_[use.face] != 0); };
        for (const BrepShellFace& face : patch.faces) {
            for (const BrepLoop& loop : model_.faces[face.face].loops) {
                for (const BrepCoedge& coedge : loop.coedges) {
                    if (model_.edges[coedge.edge].isDegenerate) continue;
                    const std::vector<EdgeUse>& uses = usesOf_[coedge.edge];
                    if (runsBack(uses[0]) == runsBack(uses[1])) return false;
                }
            }
        }
        return true;
    }

    /// Integral over the patch of a density of the place and the outward normal.
    template <class Density>
    double integral(const Patch& patch, Density density) const
    {
        double sum = 0.0;
        for (const BrepShellFace& use : patch.faces) {
            const double value = faceIntegral(model_, model_.faces[use.face], [&](const SurfacePoint& p) {
                return density(p.position, p.normal());
            });
            sum += use.isReversed ? -value : value;
        }
        return sum;
    }

    void turnOutward(Patch& patch) const
    {
        const Vec3 origin = 0.5 * (model_.box.low + model_.box.high);
        patch.volume =
            integral(patch, [&](const Vec3& p, const Vec3& n) { return dot(p - origin, n) / 3.0; });
        if (patch.volume < 0.0) turn(patch);
        patch.volume = std::abs(patch.volume);
    }

    static void turn(Patch& patch)
    {
        for (BrepShellFace& use : patch.faces) use.isReversed = !use.isReversed;
    }

    void findAround(std::size_t i)
    {
        for (std::size_t k = 0; k < patches_.size(); ++k) {
            if (k != i && patches_[k].volume > patches_[i].volume && isInside(patches_[i], patches_[k]))
                patches_[i].around.push_back(k);
        }
    }

    /// By the side of the outer patch that a place on the inner one is on, at the first place whose nearest point of the outer patch is
    /// inside of a face and not on an edge.
    [[nodiscard]] bool isInside(const Patch& inner, const Patch& outer) const
    {
        for (const BrepShellFace& use : inner.faces) {
            const std::optional<bool> side = isBehind(outer, placeOn(model_.faces[use.face]));
            if (side) return *side;
        }
        return false;
    }

    [[nodiscard]] std::optional<bool> isBehind(const Patch& patch, const Vec3& place) const
    {
        constexpr double kLeastCosine = 0.9;
        double least = std::numeric_limits<double>::infinity();
        BrepShellFace nearest;
        for (const BrepShellFace& use : patch.faces) {
            const double distance = distanceFromFace(model_, use.face, place).distance;
            if (!(distance < least)) continue;
            least = distance;
            nearest = use;
        }
        if (!nearest.face.isValid()) return std::nullopt;
        const Surface& surface = *model_.faces[nearest.face].surface;
        const SurfaceProjection foot = surface.project(place);
        const Vec3 normal = surface.evaluate(foot.parameters).normal();
        const double height = dot(place - foot.position, normal);
        if (!(std::abs(height) > kLeastCosine * least * length(normal))) return std::nullopt;
        return (height < 0.0) != nearest.isReversed;
    }

    [[nodiscard]] Vec3 placeOn(const BrepFace& face) const
    {
        const BrepCoedge& coedge = face.loops.front().coedges.front();
        return face.surface->position(
            coedge.parameterCurve->position(model_.edges[coedge.edge].part.at(0.5)));
    }

    [[nodiscard]] bool isVoid(std::size_t i) const { return patches_[i].around.size() % 2 == 1; }

    void makeSolid(std::size_t i)
    {
        BrepSolid solid;
        const auto add = [&](const Patch& patch) {
            solid.shells.push_back({patch.faces, true});
            for (const BrepShellFace& use : patch.faces) model_.faces[use.face].isReversed = use.isReversed;
        };
        add(patches_[i]);
        std::vector<std::string> faces = namesOf(patches_[i].faces);
        for (std::size_t k = 0; k < patches_.size(); ++k) {
            const std::vector<std::size_t>& around = patches_[k].around;
            const bool isOwnVoid = isVoid(k) && around.size() == patches_[i].around.size() + 1 &&
                                   std::find(around.begin(), around.end(), i) != around.end();
            if (!isOwnVoid) continue;
            Patch inward = patches_[k];
            turn(inward);
            add(inward);
            const std::vector<std::string> more = namesOf(inward.faces);
            faces.insert(faces.end(), more.begin(), more.end());
        }
        model_.solids.push_back(std::move(solid));
        const BrepSolidId id(static_cast<std::uint32_t>(model_.solids.size() - 1));
        model_.notes.push_back(nameOf(id) + " was made of the closed shell of " + listOf(faces));
    }

    static std::vector<std::string> namesOf(std::vector<BrepShellFace> faces)
    {
        std::sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.face < b.face; });
        std::vector<std::string> names;
        for (const BrepShellFace& use : faces) names.push_back(nameOf(use.face));
        return names;
    }

    BrepModel& model_;
    std::vector<BrepShellFace> loose_;
    IdVector<BrepEdgeId, std::vector<EdgeUse>> usesOf_;
    IdVector<BrepFaceId, std::uint8_t> way_;
    std::vector<Patch> patches_;
};

}  // namespace

void closeShells(BrepModel& model) { ShellClosing(model).run(); }

}  // namespace mesher
