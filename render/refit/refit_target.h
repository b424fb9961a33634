// What strokes that are made anew are to look like, and how near they come.
#pragma once

#include "render/fitting/fit_picture.h"
#include "render/refit/refit_scope.h"
#include "render/renderer.h"

namespace suffuse::refit {

/// What the new strokes are to look like: a picture of the sheet, from a file or as another painting has it, or what
/// the chosen strokes show.
struct RefitGoal {
    QByteArray picture;   ///< of a file, if that is the goal
    QString name;         ///< of the file, for messages
    PaintingPtr painting; ///< if that is the goal

    bool isOwnLook() const { return picture.isEmpty() && !painting; }
};

/// Pictures of a scope at one size.
class RefitPictures {
public:
    /// The area of the scope at no more than `mostPixels` pixels, up to four for a unit where strokes are fine. All are
    /// drawn by `renderer`, which outlives them.
    RefitPictures(const RefitScope &scope, const RefitGoal &goal, Renderer &renderer, int mostPixels,
                  const std::atomic<bool> *cancel = nullptr);

    /// The target of a fit of new strokes, which has a unit for each of the painting's, from the corner of the area on.
    /// Below lies the ground, as it is drawn. What lies above mixes over the new strokes by B ← gain·B + offset in R,
    /// Y, B at each pixel: so a goal of the whole picture becomes (goal − offset)/gain, and a pixel counts by gain².
    /// Where the sheet is not opaque, or the scope is an isolated group, pictures on white and on black are the target,
    /// so that coverage is kept. A goal that is no own look needs a scope that is the whole painting.
    Result<fitting::FitTarget> target() const;

    /// How far a painting is from the goal over an area: the root mean square and the greatest difference of R, G and
    /// B, in 255ths. A sheet that is not opaque counts on white and on black.
    struct Difference {
        double rootMeanSquare = 0, greatest = 0;
    };
    Result<Difference> differenceOf(const Painting &painting, const Rect &area) const;

private:
    Result<fitting::FitPicture> drawn(const Painting &painting, const Rect &area, int width, int height) const;
    Result<fitting::FitPicture> goalOn(const Colour &sheet, const Rect &area, int width, int height) const;
    Result<fitting::FitPicture> pictureOfFile(const Rect &area, int width, int height) const;
    void lookThrough(fitting::FitPicture &goal, const fitting::FitPicture *above, fitting::FitPicture *weight) const;

    const RefitScope &m_scope;
    const RefitGoal &m_goal;
    Renderer &m_renderer;
    const std::atomic<bool> *m_cancel;
    double m_scale = 1; ///< pixels for each unit
    int m_width = 1, m_height = 1;
};

/// The area of the scope and what is seen of new strokes, as far as the sheet goes.
Rect areaWith(const RefitScope &scope, const StrokeList &strokes);
/// The strokes of a fit of the target, in their place on the sheet.
StrokeList placed(const RefitScope &scope, const Painting &fitted);

} // namespace suffuse::refit
