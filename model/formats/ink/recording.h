// A pen recording of any format, and how it becomes a painting (docs/file-format.md, "Recordings").
#pragma once

#include "model/formats/messages.h"
#include "model/painting/painting.h"
#include "model/brush/stroke_builder.h"

#include <optional>

namespace suffuse {

/// Pen paths in the recording's own coordinates and clock.
struct Recording {
    struct Path {
        std::vector<PenSample> samples;
        std::optional<Colour> colour; ///< the brush's where absent
        /// What is to be seen of each sample when dry, across, in the recording's units; empty: as the brush makes it
        /// of the pressure.
        std::vector<double> widths;
    };
    std::vector<Path> paths;
    QString leftOut; ///< what else the file holds, as a sentence for people; empty: nothing
};

/// Time that one point takes where a recording has no times, and the pause between its strokes.
inline constexpr Microseconds assumedStep = 8'000;
inline constexpr Microseconds assumedPause = 300'000;

/// PenSample::tilt of a pen that stands `altitude` radians over the tablet.
float tiltOf(double altitude);

/// Paints every path with `brush`, in the path's own colour and widths where it has them. 1 input unit = 1 canvas unit;
/// the canvas is the samples' bounds grown by 2s on each side, rounded up to whole units, and all is moved so that it
/// starts at (0, 0); the first sample is at time 0. Fails where there is no sample, a value is not finite, or the
/// canvas would be larger than 1e6 units.
Result<Painting> paintRecording(const Recording &recording, const Brush &brush, const QString &fileName);

/// Readers of the single formats.
Result<Recording> readInkCsv(const QByteArray &bytes, const QString &fileName);
Result<Recording> readMyPaintEvents(const QByteArray &bytes, const QString &fileName);
Result<Recording> readUniversalInk(const QByteArray &bytes, const QString &fileName);
Result<Recording> readExcalidraw(const QByteArray &bytes, const QString &fileName);

/// A finite decimal number that fills the whole text (white space around it aside); nothing else.
std::optional<double> numberIn(std::string_view text);
/// The text without white space at its ends.
std::string_view trimmed(std::string_view text);
/// "line 3, column 7", counted from 1, of a byte position.
QString placeOf(const QByteArray &bytes, qsizetype position);

} // namespace suffuse
