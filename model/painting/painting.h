#pragma once

#include "model/painting/blend.h"
#include "model/painting/stroke_list.h"
#include "model/painting/text.h"

#include <QByteArray>

#include <memory>
#include <optional>
#include <unordered_set>
#include <vector>

namespace suffuse {

enum class PaperKind : std::uint8_t { None, Procedural, Image };
/// What procedural paper is made of.
enum class PaperGrain : std::uint8_t { Tooth, Fibres, Weave };

/// The paper's texture η (eq 16), which docs/paper.md defines. With strength 0 or kind None, η = 1.
struct Paper {
    PaperKind kind = PaperKind::None;
    std::uint32_t seed = 1;
    float scale = 24;      ///< procedural: wavelength of the coarsest octave, a thread's width, units; image: units per
                           ///< image pixel; (0, 1e6]
    float strength = 0.5f; ///< [0, 1]
    EncodedImage image;    ///< for PaperKind::Image
    PaperGrain grain = PaperGrain::Tooth; ///< for PaperKind::Procedural
};
bool operator==(const Paper &a, const Paper &b);

/// The sheet. Its top left corner is (0, 0), and y points down. What is painted beyond it is kept.
struct Canvas {
    double width = 1024;           ///< units, (0, 1e6]
    double height = 768;           ///< units, (0, 1e6]
    Colour background{0, 0, 0, 1}; ///< under all strokes; red, yellow, blue and opacity, each in [0, 1]: opaque white
    Paper paper;
    friend bool operator==(const Canvas &, const Canvas &) = default;
    /// The area of the whole sheet, units.
    Rect area() const { return Rect::of(0, 0, width, height); }
};

/// How the strokes of a wash show, which are one stroke: their densities add up, as those of paint that is laid wet
/// into wet (docs/solver.md, "Washes").
struct Wash {
    Style style; ///< in place of the strokes' own
    Mix mix;     ///< in place of the strokes' own
    friend bool operator==(const Wash &, const Wash &) = default;
};

/// A colour that people mark groups with, to find them. It is not seen in the picture.
enum class GroupTag : std::uint8_t { None, Red, Orange, Yellow, Green, Blue, Violet, Brown, Grey };
inline constexpr int groupTags = int(GroupTag::Grey) + 1;

/// A group of strokes, which stand together in the order.
///
/// Its strokes mix with what lies below as if there were no group, unless it is isolated: then they mix among
/// themselves, and their picture is put on what lies below (docs/solver.md, "Groups that blend").
struct Group {
    GroupId id = 0;      ///< 1 or more, and unique
    QString name;        ///< as it was typed; it may be empty, and two groups may have one name
    GroupId parent = 0;  ///< the group that it is in; 0: none
    bool visible = true; ///< whether it and all in it are visible
    bool locked = false; ///< whether it and all in it are locked: seen, but not changed by tools
    SharedText text{};   ///< what its strokes, a letter each, were made from; none: they are no text
    float opacity = 1;   ///< with which its picture is put on what lies below, [0, 1]; below 1 it is isolated
    BlendMode blend = BlendMode::Normal; ///< how it is put there; any other one isolates it
    bool isolated = false;               ///< whether it is isolated in any case
    bool clips = false; ///< whether it is seen only where that is which lies below it in the same group; isolates it
    bool mask = false;  ///< whether it is not seen itself, but the others of the same group only where it is
    std::optional<Wash> wash{}; ///< if its strokes, and those of the groups in it, are one
    bool solo = false;          ///< whether only such groups are visible, as long as there are any
    GroupTag tag = GroupTag::None;
    bool draft = false; ///< whether it is seen while one paints, but not in pictures that are exported
    /// Whether the way in which it is put on what lies below isolates it, whatever its switch says.
    bool blends() const { return opacity < 1 || blend != BlendMode::Normal || clips || mask; }
    /// Whether its strokes mix among themselves.
    bool isIsolated() const { return isolated || blends(); }
    friend bool operator==(const Group &, const Group &) = default;
};

/// A colour of the painting's palette, in the order of the palette.
struct Swatch {
    QString name;  ///< may be empty, and two swatches may have one name
    Colour colour; ///< red, yellow, blue and opacity, each in [0, 1]
    /// When the swatch is given another colour, every segment of the painting whose red, yellow and blue are exactly
    /// those of the swatch gets that colour, too.
    bool linked = false;
    friend bool operator==(const Swatch &, const Swatch &) = default;
};

/// A picture to paint over; never part of the rendered picture.
struct Underlay {
    EncodedImage image;
    Rect area;            ///< canvas units
    float opacity = 0.5f; ///< [0, 1]
    bool visible = true;
};
bool operator==(const Underlay &a, const Underlay &b);

/// The painting, which is an immutable value once it is shared. Strokes stand from bottom to top.
struct Painting {
    Canvas canvas;
    StrokeList strokes;                       ///< ids are 1 or more, and unique
    std::vector<Group> groups;                ///< in any order; no group is within itself
    std::vector<Swatch> swatches;             ///< the palette, in its order
    std::shared_ptr<const Underlay> underlay; ///< null: none

    /// The stroke with an id; null where there is none.
    StrokePtr find(StrokeId id) const;
    /// The group with an id; null where there is none.
    const Group *findGroup(GroupId id) const;
    /// The position of a stroke in the order, or -1.
    int indexOf(StrokeId id) const;
    /// Whether a stroke is visible, all groups around it are, and none is solo that is not around it. Who asks this of
    /// many strokes makes a `Visibility`.
    bool isVisible(const Stroke &stroke) const;
    /// Whether a stroke is locked, or a group around it is.
    bool isLocked(const Stroke &stroke) const;
    /// The number of segments of all strokes, hidden ones included.
    std::size_t segmentCount() const;
    /// The moment when all has dried, µs, which is the default document time. It is 0 without strokes.
    Microseconds end() const;
    StrokeId nextStrokeId() const; ///< greatest id + 1
};
using PaintingPtr = std::shared_ptr<const Painting>;

/// Which groups of a painting are visible, all groups around them included: found once for many strokes.
class Visibility {
public:
    explicit Visibility(const std::vector<Group> &groups);

    bool operator()(const Stroke &stroke) const
    {
        return stroke.visible && (stroke.group == 0 ? !m_anySolo : !m_hidden.contains(stroke.group));
    }

private:
    bool m_anySolo = false;
    std::unordered_set<GroupId> m_hidden;
};

/// Texts that follow a stroke which is not there follow none; the curve that they have stays.
void forgetLostCurves(Painting &painting);
/// The painting as it is exported: groups that are drafts are hidden, and not solo.
PaintingPtr withoutDrafts(PaintingPtr painting);
/// The ids of the strokes from bottom to top.
std::vector<StrokeId> orderOf(const Painting &painting);
/// Deep equality: values are compared, not pointers.
bool operator==(const Painting &a, const Painting &b);

/// A hash over everything that a file stores, 32 bytes (SHA-256). Equal paintings have equal hashes.
QByteArray hashOf(const Painting &painting);

} // namespace suffuse
