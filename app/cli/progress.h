// A line on the terminal that says how far long work has come.
#pragma once

#include <QElapsedTimer>
#include <QString>

#include <mutex>

namespace suffuse::cli {

/// Shows "TEXT 42 %" on stderr where that is a terminal, once the work has taken a moment; any thread. Goes away with
/// the object.
class ProgressLine {
public:
    /// `withRest`: also shows the time that is left.
    explicit ProgressLine(const QString &text, bool withRest = false);
    ~ProgressLine();
    ProgressLine(const ProgressLine &) = delete;
    ProgressLine &operator=(const ProgressLine &) = delete;

    /// `done` of `all`; less than before: the work began anew.
    void show(qint64 done, qint64 all);

private:
    const QByteArray m_text;
    const bool m_withRest;
    const bool m_shown;
    QElapsedTimer m_clock;
    std::mutex m_mutex;
    int m_percent = -1;
};

} // namespace suffuse::cli
