/** The commands that fetch the client and pull a target into the folder that they are run in. */
export function pullCommands(server: string, projectId: string, target: string): string[] {
  const program = `${server}/v1/projects/${projectId}/soundlist.pyz`
  return [
    `curl -fsSO -H "Authorization: Bearer $SOUNDLIST_TOKEN" ${program}`,
    `python3 soundlist.pyz pull --server ${server} --project ${projectId} --target ${shellWord(target)}`,
  ]
}

function shellWord(text: string): string {
  return /^[\w.][\w.-]*$/.test(text) ? text : `'${text.replaceAll("'", `'\\''`)}'`
}
