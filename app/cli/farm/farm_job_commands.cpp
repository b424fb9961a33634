// The work of a farm for engines that others made: Slurm, and what reads Open Job Descriptions or Flamenco's job types.
#include "app/cli/farm/farm_commands.h"

#include <QCoreApplication>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>

namespace suffuse::cli {

namespace {

/// A word of a shell script.
QString quoted(QString text)
{
    return '\'' + text.replace('\'', QStringLiteral("'\\''")) + '\'';
}

void addTasks(CommandLine &line)
{
    line.add(
        {"tasks"},
        QCoreApplication::translate("Cli", "Into how many tasks the work is divided (default: one for 64 pieces)."),
        "N");
}

/// How many tasks; the error is one of usage.
Result<qint64> tasksOf(const CommandLine &line, const FarmPlan &plan)
{
    if (!line.isSet("tasks"))
        return std::clamp<qint64>((plan.pieces() + 63) / 64, 1, 1000);
    bool ok = false;
    const qint64 tasks = line.value("tasks").toLongLong(&ok);
    if (!ok || tasks < 1 || tasks > 1'000'000)
        return Error{
            QCoreApplication::translate("Cli", "--tasks %1: give a whole number, at least 1").arg(line.value("tasks"))};
    return tasks;
}

QString program()
{
    return QCoreApplication::applicationFilePath();
}

/// The script of the array; each task draws its share.
QString slurmScript(const FarmPlan &plan, qint64 tasks, const QString &cpus)
{
    return QStringLiteral(
               "#!/bin/sh\n"
               "#SBATCH --job-name=suffuse\n"
               "#SBATCH --array=1-%1\n"
               "#SBATCH --requeue\n"
               "#SBATCH --open-mode=append\n"
               "#SBATCH --cpus-per-task=%2\n"
               "#SBATCH --output=%3/logs/%a.log\n"
               "%4 farm run %5 --task \"$SLURM_ARRAY_TASK_ID/%1\" --threads \"$SLURM_CPUS_PER_TASK\"\n"
               "code=$?\n"
               "# A worker that was killed, as when memory runs out, is started again, three times at most.\n"
               "if [ $code -gt 128 ] && [ \"${SLURM_RESTART_COUNT:-0}\" -lt 3 ]; then\n"
               "    scontrol requeue \"$SLURM_JOB_ID\"\n"
               "fi\n"
               "exit $code\n")
        .arg(tasks)
        .arg(cpus, plan.folder, quoted(program()), quoted(plan.folder));
}

QString slurmJoinScript(const FarmPlan &plan)
{
    return QStringLiteral("#!/bin/sh\n"
                          "#SBATCH --job-name=suffuse-join\n"
                          "#SBATCH --output=%1/logs/join.log\n"
                          "exec %2 farm join %3\n")
        .arg(plan.folder, quoted(program()), quoted(plan.folder));
}

/// Gives a script to sbatch and returns the job's number.
Result<QString> submit(const QStringList &options, const QString &script)
{
    QProcess sbatch;
    sbatch.start(QStringLiteral("sbatch"), QStringList{QStringLiteral("--parsable")} + options + QStringList{script});
    if (!sbatch.waitForStarted())
        return Error{QCoreApplication::translate(
            "Cli", "sbatch cannot be started: install Slurm (slurm-client), or use --write-only")};
    sbatch.waitForFinished(-1);
    const QString said = QString::fromLocal8Bit(sbatch.readAllStandardOutput()).trimmed();
    if (sbatch.exitStatus() != QProcess::NormalExit || sbatch.exitCode() != 0)
        return Error{QStringLiteral("sbatch: %1").arg(QString::fromLocal8Bit(sbatch.readAllStandardError()).trimmed())};
    return said.section(';', 0, 0);
}

struct FarmJob {
    FarmPlan plan;
    qint64 tasks;
};

/// Parses a command of one folder that divides the work; its job, or the exit code in `code`.
std::optional<FarmJob> jobOf(const QString &command, CommandLine &line, const QStringList &arguments, int &code)
{
    addTasks(line);
    if (const std::optional<int> ended = line.parse(arguments)) {
        code = *ended;
        return {};
    }
    const Result<FarmPlan> plan = readPlan(line.argument(0));
    if (!plan) {
        code = fail(plan.error());
        return {};
    }
    const Result<qint64> tasks = tasksOf(line, *plan);
    if (!tasks) {
        code = failUsage(command, tasks.error());
        return {};
    }
    return FarmJob{*plan, *tasks};
}

QJsonObject openJdAction(const QStringList &arguments)
{
    return {{"actions", QJsonObject{{"onRun", QJsonObject{{"command", program()},
                                                          {"args", QJsonArray::fromStringList(arguments)}}}}}};
}

} // namespace

int farmSlurmCommand(const QStringList &arguments)
{
    CommandLine line("farm slurm",
                     QCoreApplication::translate("Cli", "Submits the tasks as a job array, and the joining after it."),
                     {"FOLDER"});
    line.add({"cpus"}, QCoreApplication::translate("Cli", "Cores of each task (default 2)."), "N");
    line.add({"write-only"}, QCoreApplication::translate("Cli", "Writes the scripts, and submits nothing."));
    int code = Done;
    const std::optional<FarmJob> job = jobOf("farm slurm", line, arguments, code);
    if (!job)
        return code;
    bool ok = true;
    if (line.isSet("cpus") && (line.value("cpus").toInt(&ok) < 1 || !ok))
        return failUsage(
            "farm slurm",
            QCoreApplication::translate("Cli", "--cpus %1: give a whole number, at least 1").arg(line.value("cpus")));
    QDir().mkpath(job->plan.folder + QStringLiteral("/logs"));
    const QString script = job->plan.folder + QStringLiteral("/slurm.sh"),
                  joinScript = job->plan.folder + QStringLiteral("/slurm-join.sh");
    for (const auto &[path, text] :
         {std::pair(script,
                    slurmScript(job->plan, job->tasks, line.isSet("cpus") ? line.value("cpus") : QStringLiteral("2"))),
          std::pair(joinScript, slurmJoinScript(job->plan))})
        if (const Result<void> written = replaceFile(path, text.toLocal8Bit(), true); !written)
            return fail(written.error());
    if (line.isSet("write-only"))
        return print(script + '\n' + joinScript + '\n');
    const Result<QString> array = submit({}, script);
    if (!array)
        return fail(array.error());
    const Result<QString> joining = submit({QStringLiteral("--dependency=afterok:%1").arg(*array)}, joinScript);
    if (!joining)
        return fail(joining.error());
    return print(QCoreApplication::translate("Cli", "job %1: %2 tasks; job %3 joins what they draw")
                     .arg(*array)
                     .arg(job->tasks)
                     .arg(*joining) +
                 '\n');
}

int farmOpenJdCommand(const QStringList &arguments)
{
    CommandLine line("farm openjd",
                     QCoreApplication::translate("Cli", "Prints a job template of the Open Job Description."),
                     {"FOLDER"});
    int code = Done;
    const std::optional<FarmJob> job = jobOf("farm openjd", line, arguments, code);
    if (!job)
        return code;
    const QJsonObject parameter{{"name", "Task"}, {"type", "INT"}, {"range", QStringLiteral("1-%1").arg(job->tasks)}};
    const QJsonObject draw{{"name", "Draw"},
                           {"parameterSpace", QJsonObject{{"taskParameterDefinitions", QJsonArray{parameter}}}},
                           {"script", openJdAction({"farm", "run", job->plan.folder, "--task",
                                                    QStringLiteral("{{Task.Param.Task}}/%1").arg(job->tasks)})}};
    const QJsonObject join{{"name", "Join"},
                           {"dependencies", QJsonArray{QJsonObject{{"dependsOn", "Draw"}}}},
                           {"script", openJdAction({"farm", "join", job->plan.folder})}};
    return printJson(
        {{"specificationVersion", "jobtemplate-2023-09"}, {"name", "Suffuse"}, {"steps", QJsonArray{draw, join}}});
}

int farmFlamencoCommand(const QStringList &arguments)
{
    CommandLine line("farm flamenco",
                     QCoreApplication::translate("Cli", "Prints a job type of Flamenco 3 for its folder of scripts."),
                     {"FOLDER"});
    int code = Done;
    const std::optional<FarmJob> job = jobOf("farm flamenco", line, arguments, code);
    if (!job)
        return code;
    const auto json = [](const QString &text) {
        const QByteArray list = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
        return QString::fromUtf8(list.mid(1, list.size() - 2));
    };
    return print(
        QStringLiteral(
            "const JOB_TYPE = { label: \"Suffuse\", settings: [\n"
            "  { key: \"folder\", type: \"string\", default: %1, description: \"The shared folder with the plan\" },\n"
            "  { key: \"tasks\", type: \"int32\", default: %2, description: \"How many tasks\" },\n"
            "] };\n\n"
            "function compileJob(job) {\n"
            "  const command = args => author.Command(\"exec\", { exe: %3, args: [\"farm\", ...args] });\n"
            "  const join = author.Task(\"join\", \"misc\");\n"
            "  join.addCommand(command([\"join\", job.settings.folder]));\n"
            "  for (let i = 1; i <= job.settings.tasks; ++i) {\n"
            "    const task = author.Task(\"draw-\" + i, \"misc\");\n"
            "    task.addCommand(command([\"run\", job.settings.folder, \"--task\", i + \"/\" + "
            "job.settings.tasks]));\n"
            "    join.addDependency(task);\n"
            "    job.addTask(task);\n"
            "  }\n"
            "  job.addTask(join);\n"
            "}\n")
            .arg(json(job->plan.folder))
            .arg(job->tasks)
            .arg(json(program())));
}

} // namespace suffuse::cli
