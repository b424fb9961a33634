#pragma once

#include "model/painting/painting.h"
#include "render/fitting/fitting.h"

#include <QImage>
#include <QObject>

#include <functional>
#include <thread>

namespace suffuse {

/// What a fit is to be like.
struct FitWish {
    int strokes = 256;
    int steps = 1200;
    int pixels = fitting::usualFitPixels; ///< The picture is averaged down to so many.
    StyleKind style = StyleKind::Feathering;
    int paints = 0;           ///< 0: each stroke has a colour of its own
    double leastWidth = 0;    ///< pixels of the picture's file; 0: none
    double greatestWidth = 0; ///< pixels of the picture's file; 0: none
    std::uint64_t seed = 1;
    friend bool operator==(const FitWish &, const FitWish &) = default;

    /// Whether a fit can begin with the strokes of one that was made by another wish for the same picture: where it
    /// asks for fewer of them or for another kind, or for another roll of the dice, it must begin anew.
    bool goesOnFrom(const FitWish &before) const
    {
        return strokes >= before.strokes && style == before.style && seed == before.seed;
    }
};

/// Finds what is fitted, at no more than so many pixels, on the thread of the job. It stops with an error soon after
/// the flag is set.
using ReadTarget = std::function<Result<fitting::FitTarget>(int pixels, const std::atomic<bool> *cancel)>;

/// How far a fit has come.
struct FitNews {
    QImage picture;        ///< of the strokes so far; null: none were drawn yet
    QImage original;       ///< what is fitted, at the same size
    int strokes = 0;
    double peakRatio = 0;  ///< dB; 0 while there is no picture
    double progress = 0;   ///< [0, 1]
    double seconds = 0;    ///< of work, without the time when it stood still
};

/// The result: the strokes so far on a canvas that has a unit for each pixel of the file, and how the picture is called.
struct FitResult {
    Painting painting;
    QString name;
};

/// Fits strokes to a picture on a thread of its own. It touches no painting.
class FitJob : public QObject {
    Q_OBJECT

public:
    explicit FitJob(QObject *parent = nullptr);
    ~FitJob() override; ///< stops and waits

    /// Takes another picture and forgets the strokes of the one before. It is decoded when the fit is started; `place`
    /// stands in messages, and `name` is what the strokes will be called after.
    void setPicture(EncodedImage image, const QString &place, const QString &name);
    /// The same for what is no file of a picture.
    void setTarget(ReadTarget read, const QString &name);
    bool hasPicture() const { return bool(m_read); }
    /// Goes on with what was stopped, begins with the strokes so far, or begins anew, whatever the wish allows. What
    /// runs is stopped first.
    void start(const FitWish &wish);
    /// Stops after some tens of milliseconds at the most, and waits for that. What was done stays.
    void stop();
    /// Stops without waiting: what the thread still does is for nothing, and nothing more is told.
    void cancel();
    /// Cancels and goes, as soon as the thread has ended. Whoever owns it, it is not to be used after that.
    void abandon();
    bool isRunning() const { return m_running; }
    const FitNews &news() const { return m_news; }
    /// What it has made so far, with no more colours than were asked for. To be asked while it does not run.
    FitResult result() const;
    /// Width and height of the picture's file; 0 before it was read.
    QSizeF size() const { return m_size; }

signals:
    /// There are news, ten times a second at the most.
    void progressed();
    /// It has come to its end, or stands still for this reason.
    void ended(const QString &error);

private:
    void run(const FitWish &wish);
    Result<void> work(const FitWish &wish);
    Result<void> prepare(const FitWish &wish);
    void tell();
    void join();

    ReadTarget m_read;
    QString m_name;
    FitNews m_news;  ///< of the caller's thread
    QSizeF m_size;   ///< of the caller's thread
    bool m_running = false;
    bool m_isBusy = false; ///< The thread may be at work, though nobody waits for it.
    bool m_isAbandoned = false;
    int m_run = 0;   ///< News of a run that is over are not heard.

    // What follows is the thread's while it runs.
    std::shared_ptr<const fitting::FitTarget> m_target;
    int m_pixels = 0; ///< that were asked for when the target was read
    QImage m_original;
    std::shared_ptr<gradient::Differentiator> m_differentiator; ///< of the fits, one after another
    std::unique_ptr<fitting::Fitting> m_fit;
    FitWish m_wish; ///< of the fit
    double m_seconds = 0;

    std::atomic<bool> m_cancel = false;
    std::atomic<bool> m_untold = false; ///< News are under way to the caller's thread.
    std::jthread m_thread;
};

} // namespace suffuse
