// A folder that only the editor knows, as that of a repository in the browser: two programs and a machine file.
const vscode = require("vscode");

const files = new Map([
  ["/part.nc", "%\nO1 (SQUARE)\nG21 G90 G54\nS900 M3\nG0 X0. Y0. Z5.\nM98 P2\nG3 X10. Y12. I0. J10. F100.\nM30\n%\n"],
  ["/O2.nc", "%\nO2 (DOWN)\nG1 Z-1. F100.\nM99\n%\n"],
  ["/chordal.toml", 'machine = "haas-vf2"\n'],
]);
const encode = (text) => new TextEncoder().encode(text);

exports.activate = (context) => {
  const changed = new vscode.EventEmitter();
  const missing = (uri) => vscode.FileSystemError.FileNotFound(uri);
  const provider = {
    onDidChangeFile: changed.event,
    watch: () => new vscode.Disposable(() => undefined),
    stat: (uri) => {
      if (uri.path === "/") return { type: vscode.FileType.Directory, ctime: 0, mtime: 0, size: 0 };
      const text = files.get(uri.path);
      if (text === undefined) throw missing(uri);
      return { type: vscode.FileType.File, ctime: 0, mtime: 1, size: encode(text).length };
    },
    readDirectory: () => [...files.keys()].map((path) => [path.slice(1), vscode.FileType.File]),
    readFile: (uri) => {
      const text = files.get(uri.path);
      if (text === undefined) throw missing(uri);
      return encode(text);
    },
    writeFile: (uri, content) => {
      files.set(uri.path, new TextDecoder().decode(content));
      changed.fire([{ type: vscode.FileChangeType.Changed, uri }]);
    },
    createDirectory: () => undefined,
    delete: (uri) => void files.delete(uri.path),
    rename: () => undefined,
  };
  context.subscriptions.push(vscode.workspace.registerFileSystemProvider("shop", provider, { isCaseSensitive: true }));
};
