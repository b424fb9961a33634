// An extension: a program of somebody else that makes another painting of a painting (docs/extensions.md).
#pragma once

#include <QCoreApplication>
#include <QJsonValue>
#include <QString>
#include <QStringList>

#include <map>
#include <vector>

namespace suffuse {

/// The context of translations for what extensions and their programs do wrong.
struct ExtensionMessages {
    Q_DECLARE_TR_FUNCTIONS(suffuse::Extensions)
};

/// A text in several languages, by their codes ("en", "de", "zh_CN", "fr", "es", "ja").
struct Words {
    std::map<QString, QString> byLanguage;

    /// In a language; where it is missing, in English, and where that is missing, too, in whichever there is.
    QString in(const QString &language) const;
    bool isEmpty() const { return byLanguage.empty(); }
};

/// What people choose before the program starts.
struct ExtensionField {
    enum class Type { Number, Whole, Choice, Switch, Text, Colour, File };
    struct Choice {
        QString id;
        Words label;
    };

    Type type = Type::Number;
    QString id; ///< letters, digits and underscores
    Words label;
    Words tip;
    Words unit;                 ///< of numbers; may be empty
    double least = 0, most = 1; ///< of numbers
    int decimals = 2;           ///< of numbers
    std::vector<Choice> choices;
    bool saves = false;  ///< of files: the program writes it
    QStringList endings; ///< of files, without dots; the usual one comes first
    /// A number, a switch's state, the id of a choice, a text, a path, or an array of red, yellow, blue and opacity.
    QJsonValue usual;
};

inline constexpr qint64 megabyte = 1 << 20; ///< bytes

/// What a program may use. It is ended where it uses more.
struct ExtensionLimits {
    int seconds = 60;
    int memory = 2048; ///< MB
    int written = 512; ///< MB
};

struct Extension {
    enum class Passes { Painting, Selection, Layer };

    QString folder; ///< absolute
    QString id;     ///< lower case letters, digits and hyphens
    Words name;
    Words description;
    std::vector<Words> menu; ///< submenus, from the outermost
    std::vector<ExtensionField> fields;
    Passes passes = Passes::Painting;
    bool asText = true; ///< paintings go in and out as text form, and not as .suffuse
    bool returnsPainting = true;
    QStringList program;       ///< with {python3} and {folder} as they stand in the manifest
    QStringList pythonModules; ///< that the program imports
    ExtensionLimits limits;
    bool network = false; ///< it asks for the network
};

} // namespace suffuse
