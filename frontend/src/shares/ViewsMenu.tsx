import { Menu } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { defaultParseSearch, defaultStringifySearch } from '@tanstack/react-router'

import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { Field, Submit } from '@/ui/Form'
import type { MenuProps } from '@/ui/LazyMenu'
import { OpenedMenu } from '@/ui/OpenedMenu'

import { useDeleteView, useSaveView, type ViewedPage, viewsQuery } from './api'
import classes from './ViewsMenu.module.css'

interface ViewsMenuProps extends MenuProps {
  projectId: string
  page?: ViewedPage
  /** The filter as the address has it now. */
  search: object
  onOpen: (search: Record<string, unknown>) => void
}

/** The filters that a person kept: opened, kept under a name, deleted. */
export function ViewsMenu({ button, projectId, page = 'sound_list', search, onOpen }: ViewsMenuProps) {
  const { data: views } = useQuery(viewsQuery(projectId, page))
  const save = useSaveView(projectId, page)
  const remove = useDeleteView(projectId)
  return (
    <OpenedMenu button={button} position="bottom-end" width={260}>
      <Menu.Label>{page === 'review_queue' ? 'Views of the team' : 'Your views'}</Menu.Label>
      {views?.length === 0 && <Menu.Label>No views yet</Menu.Label>}
      {views?.map((view) => (
        <Menu.Item key={view.id} onClick={() => onOpen(defaultParseSearch(`?${view.query}`))}>
          {view.name}
        </Menu.Item>
      ))}
      <Menu.Divider />
      <DraftForm
        className={`grid gap-2 ${classes.form}`}
        draftKey={`view:${page}:${projectId}`}
        initialValues={{ name: '' }}
        mutation={save}
        onSubmit={({ name }, onSent) =>
          save.mutate(
            { name: name.trim(), query: defaultStringifySearch(search as Record<string, unknown>).replace(/^\?/, '') },
            {
              onSuccess: (view) => {
                onSent()
                showToast(`View ${view.name} saved.`)
              },
            },
          )
        }
      >
        <Field
          name="name"
          aria-label="Name of the view"
          placeholder="Name of this filter"
          maxLength={80}
          onKeyDown={(event) => {
            if (event.key !== 'Escape' && event.key !== 'Tab') event.stopPropagation() // the menu reads letters as a choice
          }}
        />
        <Submit variant="plain" className="grid">
          Save view
        </Submit>
      </DraftForm>
      {views !== undefined && views.length > 0 && (
        <>
          <Menu.Divider />
          <Menu.Label>Delete a view</Menu.Label>
          {views.map((view) => (
            <Menu.Item key={view.id} closeMenuOnClick={false} onClick={() => remove.mutate(view.id)}>
              Delete {view.name}
            </Menu.Item>
          ))}
        </>
      )}
    </OpenedMenu>
  )
}
