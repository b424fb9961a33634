// A pen recording of any format, and how it becomes a painting (docs/file-format.md, "Recordings").
#pragma once

#include "model/brush/stroke_builder.h"
#include "model/formats/messages.h"
#include "model/painting/painting.h"

#include <optional>

namespace suffuse {

/// Paths of a pen, in the coordinates and the clock of the recording.
struct Recording {
    struct Path {
        std::vector<PenSample> samples;
        std::optional<Colour> colour; ///< if not set, the brush's colour is taken
        /// The visible width of the dry stroke at each sample, in the units of the recording. If it is empty, the brush
        /// makes the width from the pressure.
        std::vector<double> widths;
        int group = -1; ///< the index of a group; −1: none
    };
    /// A page or a layer. What is in it stands together.
    struct Group {
        QString name;
        int parent = -1; ///< the index of a group before this one; −1: none
    };
    /// A picture that was pasted between the paths.
    struct Image {
        EncodedImage bytes;
        int width = 0, height = 0; ///< pixels
        Rect area;
        std::size_t below = 0; ///< how many paths lie below it
        int group = -1;
    };
    std::vector<Path> paths;
    std::vector<Group> groups;
    std::vector<Image> images;
    std::optional<Rect> area;         ///< what the canvas shows; no value: all samples, and a margin
    std::optional<Colour> background; ///< of the canvas; no value: white
    QString leftOut;                  ///< what else is in the file, as a sentence for people; empty if nothing is
};

/// If a recording has no times, there is this pause between strokes.
inline constexpr Microseconds assumedPause = 300'000;
/// How many points the recordings have at most that are small as files and large in memory, and how many groups.
inline constexpr std::size_t mostSamples = std::size_t(1) << 21;
inline constexpr std::size_t mostGroups = std::size_t(1) << 14;
/// What a recording that is packed may have once it is unpacked, bytes.
inline constexpr qint64 largestInk = qint64(64) << 20;

/// Gives times to the paths of a recording that has none: 8 ms to a point that follows the one before closely, as
/// points of a moving pen do. Where points lie far apart the file means a line with corners, such as a rectangle. There
/// further points are set on the line, closer together towards its ends, where a hand is slower, too: the spline
/// through them is straight between the corners and round for about a unit at them.
class AssumedTimes {
public:
    /// Sets the times of a path. `widths` go along; they are empty or as many as the samples.
    void give(Recording::Path &path);
    /// The clock, at which the next path begins.
    Microseconds now() const { return m_now; }
    void setNow(Microseconds now) { m_now = now; }

private:
    Microseconds m_now = 0;
    std::size_t m_spare = mostSamples; ///< how many points may still be added to the recording
};

/// The PenSample::tilt of a pen that stands at `altitude` radians over the tablet.
float tiltOf(double altitude);

/// Paints every path with `brush`, in the path's own colour and widths if it has them. One unit of the input is one
/// canvas unit. The canvas is the recording's area, or else the box of the samples grown by 2s on each side, rounded up
/// to whole units, and all is moved so that it starts at (0, 0). Groups with something in them are groups, images are
/// pictures as paint. The first sample is at time 0. It fails if there is neither a sample nor an image, if a value is
/// not finite, or if the canvas would be larger than 1e6 units.
Result<Painting> paintRecording(const Recording &recording, const Brush &brush, const QString &fileName);

/// The readers of the formats.
Result<Recording> readInkCsv(const QByteArray &bytes, const QString &fileName);
Result<Recording> readMyPaintEvents(const QByteArray &bytes, const QString &fileName);
Result<Recording> readUniversalInk(const QByteArray &bytes, const QString &fileName);
Result<Recording> readExcalidraw(const QByteArray &bytes, const QString &fileName);
Result<Recording> readXournal(const QByteArray &bytes, const QString &fileName);
Result<Recording> readInkml(const QByteArray &bytes, const QString &fileName);
Result<Recording> readRnote(const QByteArray &bytes, const QString &fileName);

/// Whether a zip file is a notebook of Xournal++.
bool isXournalPackage(const QByteArray &bytes);

/// Whether the text that is packed in a file is a notebook of Rnote, by its beginning.
bool isRnote(std::string_view text);

/// The number in a text which, apart from white space around it, is one finite decimal number; otherwise no value.
std::optional<double> numberIn(std::string_view text);
/// The text without white space at its ends.
std::string_view trimmed(std::string_view text);
/// The place of a byte as "line 3, column 7", counted from 1.
QString placeOf(const QByteArray &bytes, qsizetype position);

} // namespace suffuse
