#pragma once

#include "app/dialogs/print/page_drawing.h"

#include <QObject>

#include <memory>
#include <optional>
#include <thread>

class QPagedPaintDevice;

namespace suffuse {

/// What a page is printed on: a printer, or else a file.
struct PrintTarget {
    QString file;  ///< a PDF that is replaced
    QString title; ///< of the PDF
    QPageLayout layout;
    double dpi = 0;
    /// Made ready: with paper, resolution and copies, and all of the sheet to draw on. Null: the file.
    std::shared_ptr<QPagedPaintDevice> printer;
};

/// Draws pages to look at, and prints one, on a thread of its own. What is cancelled or fails leaves the file as it
/// was, and gives nothing to the printer: that gets the page when it has been drawn.
class PrintJob : public QObject {
    Q_OBJECT

public:
    explicit PrintJob(QObject *parent = nullptr);
    ~PrintJob() override; ///< cancels and waits

    /// Draws a sheet to look at; what is being drawn is given up for it. Not while a page is printed.
    void preview(const PageOrder &order, double dpi);
    void print(const PageOrder &order, const PrintTarget &target);
    void cancel() { m_cancel = true; }
    bool isPrinting() const { return m_work == Work::Printing; }

signals:
    void previewed(const QImage &sheet);
    void previewFailed(const QString &error);
    void progressed(int perMille);
    void handedOver(); ///< The printer gets the page now; that cannot be cancelled.
    /// `error` is empty after success and after a cancel.
    void finished(bool printed, const QString &error);

private:
    enum class Work { None, Previewing, Printing };
    struct SheetOrder {
        PageOrder order;
        double dpi = 0;
    };

    void begin(Work work);
    void previewNext();
    Result<QImage> draw(const SheetOrder &look);
    void takePreview(Result<QImage> sheet);
    Result<void> work(const PageOrder &order, const PrintTarget &target);
    Result<void> writeFile(const PageOrder &order, const PrintTarget &target, Renderer &renderer);
    Result<void> giveToPrinter(const PageOrder &order, const PrintTarget &target, Renderer &renderer);
    void show(int perMille);

    SheetOrder m_look;
    bool m_isNew = false; ///< whether another sheet is to be looked at since this one was begun
    Work m_work = Work::None;
    std::atomic<bool> m_cancel = false;
    std::jthread m_thread;
};

} // namespace suffuse
