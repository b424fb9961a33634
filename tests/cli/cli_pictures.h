// A folder with a painting, and the pictures that suffuse-cli makes of it.
#pragma once

#include "cli_process.h"

#include "render/image_io/image_io.h"

#include <QTest>

namespace suffuse {

/// What tests of pictures derive from; the painting is "a.json".
class CliPictures : public QObject {
protected:
    void prepare()
    {
        QVERIFY(m_folder.isValid());
        QVERIFY2(imageModuleProblem().isEmpty(), qPrintable(imageModuleProblem()));
        QVERIFY(writeFile(path("a.json"), smallPainting()));
    }
    QString path(const QString &name) const { return m_folder.filePath(name); }

    FloatPicture picture(const QString &name) const
    {
        const Result<FloatPicture> read = readImage(readFile(path(name)), name);
        if (!read)
            qWarning("%s", qPrintable(read.error()));
        return read ? *read : FloatPicture();
    }

    FloatPicture rendered(const QStringList &options, const QString &name) const
    {
        const CliOutcome outcome = runCli(QStringList{"render", path("a.json"), "-o", path(name)} + options);
        if (outcome.code != 0)
            qWarning("%s", qPrintable(outcome.text()));
        return picture(name);
    }

    QTemporaryDir m_folder;
};

} // namespace suffuse
