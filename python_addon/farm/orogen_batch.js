// SPDX-License-Identifier: GPL-3.0-or-later
//
// A job type for Flamenco 3: each line of a file of jobs (python -m orogen batch) is a task, and when
// all are done the .blend is rendered. A task that is run again leaves alone what is done.

const JOB_TYPE = {
    label: "Orogen Batch",
    description: "Grow the terrains of a file of jobs, then render the .blend",
    settings: [
        { key: "jobs_file", type: "string", subtype: "file_path", required: true,
          description: "File of jobs, one a line, as JSON" },
        { key: "count", type: "int32", required: true, propargs: {min: 1},
          eval: "sum(map(bool, Path(bpy.path.abspath(settings.jobs_file)).read_text('utf-8').split('\\n')))",
          evalInfo: { showLinkButton: true, description: "Lines of the file" },
          description: "How many jobs the file has" },
        { key: "output", type: "string", subtype: "dir_path", required: true,
          description: "Folder for the terrains; each job has a folder in it" },
        { key: "formats", type: "string", default: "",
          description: "Formats beside npz, with spaces between: tif exr png16 vdb" },
        { key: "render_output", type: "string", subtype: "file_path", default: "",
          description: "Where pictures of the .blend go when all is grown, such as /renders/####. Empty: none are made" },
        { key: "frames", type: "string", default: "1", description: "Frames to render, such as 1 or 1..24" },
        { key: "python", type: "string", default: "python3", visible: "submission",
          description: "A Python of the workers' that has the package orogen" },

        { key: "blendfile", type: "string", required: true, visible: "web", description: "The .blend to render" },
    ]
};

function compileJob(job) {
    const settings = job.settings;
    const growing = growTasks(settings);
    for (const task of growing) {
        job.addTask(task);
    }
    if (settings.render_output) {
        job.addTask(renderTask(settings, growing));
    }
}

function growTasks(settings) {
    const formats = settings.formats.split(" ").filter(format => format);
    const tasks = [];
    for (let index = 0; index < settings.count; index++) {
        const task = author.Task(`grow-${index}`, "misc");
        task.addCommand(author.Command("exec", {
            exe: settings.python,
            args: [
                "-m", "orogen", "batch", settings.jobs_file,
                "--output", settings.output,
                "--index", `${index}`,
            ].concat(formats.length ? ["--format"].concat(formats) : []),
        }));
        tasks.push(task);
    }
    return tasks;
}

function renderTask(settings, growing) {
    const task = author.Task("render", "blender");
    task.addCommand(author.Command("blender-render", {
        exe: "{blender}",
        exeArgs: "{blenderArgs}",
        argsBefore: [],
        blendfile: settings.blendfile,
        args: ["--render-output", settings.render_output, "--render-frame", settings.frames],
    }));
    for (const grown of growing) {
        task.addDependency(grown);
    }
    return task;
}
