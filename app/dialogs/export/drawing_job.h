#pragma once

#include "render/drawing/drawing_file.h"

#include <QObject>

#include <optional>
#include <thread>

namespace suffuse {

/// Draws a painting as paths, compares that with the picture, and writes it when it is asked to, on a thread of its
/// own. What is cancelled or fails leaves the target as it was.
class DrawingJob : public QObject {
    Q_OBJECT

public:
    explicit DrawingJob(QObject *parent = nullptr);
    ~DrawingJob() override; ///< cancels and waits

    /// Draws a painting; what is being drawn or was drawn before is given up. Not while a drawing is written.
    void prepare(const PaintingPtr &painting, const DrawingOptions &options);
    /// What of a drawing is no part of the painting.
    struct OnPaper {
        std::optional<PageSize> paper; ///< of PDF, as PreparedDrawing has it
        double resolution = 0;         ///< the same
        PdfAbout about;                ///< of PDF
    };
    /// Writes what was prepared, which must be there.
    void write(const QString &path, const OnPaper &sheet);
    void cancel() { m_cancel = true; }
    bool isPreparing() const { return m_work == Work::Preparing; }
    bool isWriting() const { return m_work == Work::Writing; }
    /// What is ready to be written; null: nothing.
    const PreparedDrawing *ready() const { return m_ready ? &*m_ready : nullptr; }

signals:
    void progressed(int perMille); ///< of what is drawn
    /// `error` is empty if it is ready.
    void prepared(const QString &error);
    /// `error` is empty after success and after a cancel.
    void finished(bool written, const QString &error);

private:
    enum class Work { None, Preparing, Writing };
    struct Order {
        PaintingPtr painting;
        DrawingOptions options;
    };

    void begin(Work work);
    void prepareNext();
    Result<PreparedDrawing> draw(const Order &order);
    void takePrepared(Result<PreparedDrawing> drawing);

    Order m_order;
    bool m_isNew = false; ///< whether the order came while an earlier one was being done
    Work m_work = Work::None;
    std::optional<PreparedDrawing> m_ready;
    std::atomic<bool> m_cancel = false;
    std::jthread m_thread;
};

} // namespace suffuse
