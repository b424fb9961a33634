// Films as video: ffmpeg, where it is installed, gets the frames.
#include "render/film/film_kinds.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QRandomGenerator>
#include <QStandardPaths>

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <thread>

namespace suffuse {

namespace {

constexpr std::size_t mostWaiting = 4; ///< frames
constexpr int pollMs = 100;

/// Gives the frames to ffmpeg. A QProcess belongs to one thread, while frames come from any.
class VideoFilm : public OrderedFilm {
public:
    explicit VideoFilm(const FilmOptions &options) : OrderedFilm(options)
    {
        const QFileInfo target(options.path);
        m_temporary = target.dir().filePath(
            QStringLiteral(".suffuse-%1.tmp").arg(QRandomGenerator::system()->generate64(), 0, 16));
    }
    ~VideoFilm() override
    {
        stop(true);
        QFile::remove(m_temporary);
    }

    Result<void> open()
    {
        const QString program = QStandardPaths::findExecutable(QStringLiteral("ffmpeg"));
        if (program.isEmpty())
            return Error{QCoreApplication::translate("Film",
                                                     "%1: ffmpeg, which makes videos, is not installed. Install "
                                                     "it, or choose WebP or frames.")
                             .arg(m_options.path)};
        QFile file(m_temporary); // If the file cannot be written, this says why, so that ffmpeg's messages need not.
        if (!file.open(QIODevice::WriteOnly))
            return Error{QCoreApplication::translate("Film", "%1: cannot write into this folder. Choose another one.")
                             .arg(QFileInfo(m_options.path).path())};
        m_thread = std::thread([this, program] { run(program); });
        return {};
    }

    Result<void> commit() override
    {
        stop(false);
        if (!m_error.isEmpty())
            return failure();
        std::error_code error;
        std::filesystem::rename(m_temporary.toStdString(), m_options.path.toStdString(), error);
        if (error)
            return Error{QStringLiteral("%1: %2").arg(m_options.path, QString::fromLocal8Bit(error.message().c_str()))};
        return {};
    }

protected:
    Result<void> append(QByteArray pixels) override
    {
        std::unique_lock lock(m_queueMutex);
        m_changed.wait(lock, [this] { return m_waiting.size() < mostWaiting || m_over; });
        if (m_over)
            return failure();
        m_waiting.push_back(std::move(pixels));
        m_changed.notify_all();
        return {};
    }

private:
    QStringList arguments() const
    {
        const bool alpha = m_options.image.alpha;
        const bool webm = m_options.path.endsWith(QLatin1String(".webm"), Qt::CaseInsensitive);
        QStringList all{QStringLiteral("-v"), QStringLiteral("error"), QStringLiteral("-y")};
        const auto add = [&all](const char *text) { all << QString::fromLatin1(text).split(QLatin1Char(' ')); };
        add("-f rawvideo -pixel_format");
        all << (alpha ? QStringLiteral("rgba") : QStringLiteral("rgb24"));
        all << QStringLiteral("-video_size") << QStringLiteral("%1x%2").arg(m_options.width).arg(m_options.height);
        all << QStringLiteral("-framerate") << QString::number(m_options.fps, 'f', 6);
        add("-i - -an -sws_flags accurate_rnd+full_chroma_int");
        add("-colorspace bt709 -color_primaries bt709 -color_trc iec61966-2-1");
        if (webm)
            add("-vf scale=out_color_matrix=bt709 -c:v libvpx-vp9 -crf 18 -b:v 0 -row-mt 1 -deadline good -cpu-used 4");
        else // Two pixels share a colour, so the sides must be even.
            add("-vf pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709 -c:v libx264 -crf 14 -preset medium "
                "-movflags +faststart");
        add(alpha ? "-pix_fmt yuva420p -auto-alt-ref 0" : "-pix_fmt yuv420p");
        add(webm ? "-f webm" : "-f mp4");
        return all << m_temporary;
    }

    void run(const QString &program)
    {
        QProcess process;
        process.setStandardOutputFile(QProcess::nullDevice());
        process.start(program, arguments());
        QString error;
        if (!process.waitForStarted())
            error = process.errorString();
        for (QByteArray pixels; error.isEmpty() && next(pixels);) {
            process.write(pixels);
            while (process.bytesToWrite() > 0 && !m_abandoned)
                if (!process.waitForBytesWritten(pollMs) && process.state() == QProcess::NotRunning)
                    break;
            if (process.state() == QProcess::NotRunning)
                break;
        }
        process.closeWriteChannel();
        while (process.state() != QProcess::NotRunning) {
            if (m_abandoned)
                process.kill();
            process.waitForFinished(pollMs);
        }
        const QString said = QString::fromLocal8Bit(process.readAllStandardError()).trimmed().section('\n', -1);
        const bool failed = process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0;
        const std::lock_guard lock(m_queueMutex);
        m_error = !error.isEmpty() ? error : failed ? (said.isEmpty() ? process.errorString() : said) : QString();
        m_over = true;
        m_changed.notify_all();
    }

    /// Waits for the next frame. Returns false after the last one.
    bool next(QByteArray &pixels)
    {
        std::unique_lock lock(m_queueMutex);
        m_changed.wait(lock, [this] { return !m_waiting.empty() || m_ended || m_abandoned; });
        if (m_abandoned || m_waiting.empty())
            return false;
        pixels = std::move(m_waiting.front());
        m_waiting.pop_front();
        m_changed.notify_all();
        return true;
    }

    void stop(bool abandon)
    {
        {
            const std::lock_guard lock(m_queueMutex);
            m_ended = true;
            m_abandoned = m_abandoned || abandon;
        }
        m_changed.notify_all();
        if (m_thread.joinable())
            m_thread.join();
    }

    Error failure() const
    {
        return Error{QCoreApplication::translate("Film", "%1: ffmpeg could not make the video (%2). Choose another "
                                                         "format or size.")
                         .arg(m_options.path, m_error)};
    }

    QString m_temporary;
    std::mutex m_queueMutex;
    std::condition_variable m_changed;
    std::deque<QByteArray> m_waiting;
    bool m_ended = false; ///< no more frames come
    std::atomic<bool> m_abandoned = false;
    bool m_over = false; ///< ffmpeg has ended
    QString m_error;
    std::thread m_thread;
};

} // namespace

Result<std::unique_ptr<FilmWriter>> openVideo(const FilmOptions &options)
{
    auto film = std::make_unique<VideoFilm>(options);
    if (const Result<void> opened = film->open(); !opened)
        return Error{opened.error()};
    return std::unique_ptr<FilmWriter>(std::move(film));
}

} // namespace suffuse
