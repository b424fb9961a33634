// The application object of suffuse-cli.
#pragma once

#include "model/painting/letters.h"

#include <QTranslator>

#include <memory>

class QCoreApplication;

namespace suffuse::cli {

/// It starts without anything that has to do with displays, and most commands need no more. When a text is to be set
/// for the first time, another object takes its place, which knows fonts (undo/lettering/module_api.h); still without a
/// display.
class Application final : public LetterShaper {
public:
    Application(int &argc, char **argv);
    ~Application() override;
    Application(const Application &) = delete;
    Application &operator=(const Application &) = delete;

    std::shared_ptr<const ShapedLine> shape(const QString &line, const Face &face) override;
    bool hasFamily(const QString &family) override;
    QString familyFor(const QString &family) override;

private:
    LetterShaper *shaper();
    void prepare();

    int &m_argc;
    char **const m_argv;
    std::unique_ptr<QCoreApplication> m_application;
    std::unique_ptr<LetterShaper> m_shaper;
    QTranslator m_plurals; ///< of English: "1 stroke", "2 strokes"
    bool m_isAsked = false;
};

} // namespace suffuse::cli
